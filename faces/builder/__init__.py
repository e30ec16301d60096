"""Modules of the build scripts."""

import os

# Read by NumPy at import. Threads would be slower for small sums, and change the order of summation.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
