"""Modules of the scripts that build the faces, the hand and the neck."""

import os

# NumPy reads this variable when it is imported. With several threads, small sums would be slower, and the order of
# summation would vary.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
