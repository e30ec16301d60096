"""The parts of the build scripts."""

import os

# NumPy reads it when it is first imported. Small sums only: threads would take longer, and change their order.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
