"""Run the tests in blender/tests/format, which do not need Blender."""

import sys
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE.parent), str(HERE / "format")]

if __name__ == "__main__":
    suite = unittest.defaultTestLoader.discover(str(HERE / "format"))
    sys.exit(not unittest.TextTestRunner().run(suite).wasSuccessful())
