"""Creates meshes that several tests use."""

import numpy as np

from builder.part import Part


def grid(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns positions and quads of a flat sheet: n x n quads over the unit square in the plane z = 0, facing +Z."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
    positions = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(n)))
    corner = j * (n + 1) + i
    return positions, np.stack([corner, corner + 1, corner + n + 2, corner + n + 1], axis=1)


def cube() -> tuple[np.ndarray, np.ndarray]:
    """Returns positions and quads of a cube with corners at +-1 on each axis, facing outwards."""
    positions = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    return positions, quads


def sheet_part(n: int = 2) -> Part:
    """Returns the sheet of `grid` as a part. u increases to the right and v downwards."""
    positions, quads = grid(n)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    uv = np.stack([positions[:, 0], 1 - positions[:, 1]], axis=1)
    return Part("sheet", "skin", positions, np.tile([0.0, 0.0, 1.0], (len(positions), 1)), uv, triangles)
