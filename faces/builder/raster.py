"""Rasterises the texture layout of a mesh, so that maps can be painted by the position of each texel in space."""

import numpy as np
from scipy.ndimage import distance_transform_edt


class Atlas:
    """Stores the triangle and the barycentric coordinates of each texel.

    A texel outside all triangles gets the values of the nearest texel inside a triangle. `covered` is the mask of
    texels inside a triangle.
    """

    def __init__(self, uv: np.ndarray, triangles: np.ndarray, size: int):
        self.size = size
        self._triangles = triangles
        corner = uv[triangles] * size - 0.5
        owner = np.full((size, size), -1)
        weights = np.zeros((size, size, 3))
        for index, (a, b, c) in enumerate(corner):
            low = np.maximum(np.floor(np.minimum(np.minimum(a, b), c)).astype(int), 0)
            high = np.minimum(np.ceil(np.maximum(np.maximum(a, b), c)).astype(int), size - 1)
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if area == 0 or (high < low).any():
                continue
            x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
            wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
            wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
            inside = (wb >= -1e-6) & (wc >= -1e-6) & (wb + wc <= 1 + 1e-6)
            rows, cols = y[inside], x[inside]
            owner[rows, cols] = index
            weights[rows, cols] = np.stack([1 - wb - wc, wb, wc], axis=-1)[inside]
        self.covered = owner >= 0
        nearest = distance_transform_edt(~self.covered, return_distances=False, return_indices=True)
        self._owner = owner[tuple(nearest)]
        self._weights = weights[tuple(nearest)]

    def spread(self, per_vertex: np.ndarray) -> np.ndarray:
        """Interpolates values of vertices, (n,) or (n, k), at all texels: (size, size) or (size, size, k)."""
        corners = self._triangles[self._owner]
        weights = self._weights if per_vertex.ndim == 1 else self._weights[..., None]
        return sum(per_vertex[corners[..., k]] * weights[:, :, k] for k in range(3))
