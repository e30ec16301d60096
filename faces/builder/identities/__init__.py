"""Builds random heads for tests. They have different shapes and no texture maps."""
