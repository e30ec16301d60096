"""
Run the tests in blender/tests/blender. A pattern on the command line selects files.

Blender's output is written to a file, whose name is printed if a test fails.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE.parent), str(HERE / "format"), str(HERE / "blender")]

# Uses a temporary folder for Blender's settings, so that the user's settings do not affect the tests.
os.environ.setdefault("BLENDER_USER_RESOURCES", tempfile.mkdtemp(prefix="furrow-blender-"))

import bpy  # noqa: E402, F401  Provides addon_utils.

if __name__ == "__main__":
    descriptor, log = tempfile.mkstemp(prefix="furrow-blender-", suffix=".txt")
    report = os.fdopen(os.dup(2), "w")
    for stream in (1, 2):
        os.dup2(descriptor, stream)
    suite = unittest.defaultTestLoader.discover(str(HERE / "blender"), sys.argv[1] if sys.argv[1:] else "test*.py")
    passed = unittest.TextTestRunner(report, verbosity=2).run(suite).wasSuccessful()
    if not passed:
        report.write(f"Blender's output: {log}\n")
    report.flush()
    # Exits without Blender's exit handlers, which would report unfreed memory.
    os._exit(0 if passed else 1)
