"""The parts of build.py: one idea per module."""
