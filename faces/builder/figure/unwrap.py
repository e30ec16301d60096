"""Unwraps clothes: each tube becomes a rectangle, and the rectangles are packed into the unit square."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

MARGIN = 0.012  # space around each chart, uv


@dataclass
class Chart:
    """A tube of cloth. `place` returns the angle around it in radians, -pi..pi, and the height in metres."""

    kind: str
    place: Callable
    has: Callable  # returns which quads belong to the chart, by mean weights of limbs and by centre
    radius: float  # metres per radian


def unwrap(positions, quads, charts: list[Chart], limbs) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns uv (m, 2), v down; quads (f, 4) of indices into uv; and the vertex of each uv, (m,)."""
    centre = positions[quads].mean(axis=1)
    weights = {name: value[quads].mean(axis=1) for name, value in limbs.items()}
    flat = np.full((len(quads), 4, 2), np.nan)
    owner = np.full(len(quads), -1)
    for k, chart in enumerate(charts):
        own = np.flatnonzero(chart.has(weights, centre) & (owner < 0))
        owner[own] = k
        angle, height = chart.place(positions[quads[own]].reshape(-1, 3))
        angle = angle.reshape(-1, 4)
        # Corners beyond the seam continue on the side of the quad's middle.
        middle = np.arctan2(np.sin(angle).mean(axis=1), np.cos(angle).mean(axis=1))[:, None]
        angle = middle + np.arctan2(np.sin(angle - middle), np.cos(angle - middle))
        flat[own] = np.stack([chart.radius * angle, -height.reshape(-1, 4)], axis=2)
        if _area(flat[own]) < 0:
            flat[own, :, 0] *= -1
    boxes = [
        (flat[owner == k].reshape(-1, 2).min(axis=0), flat[owner == k].reshape(-1, 2).max(axis=0)) for k in range(3)
    ]
    # The trunk lies above both limbs, which lie side by side.
    sizes = [high - low for low, high in boxes]
    width = max(sizes[0][0], sizes[1][0] + sizes[2][0])
    height = sizes[0][1] + max(sizes[1][1], sizes[2][1])
    scale = np.array([(1 - 3 * MARGIN) / width, (1 - 3 * MARGIN) / height])
    origins = [
        np.array([MARGIN, MARGIN]),
        np.array([MARGIN, 2 * MARGIN + scale[1] * sizes[0][1]]),
        np.array([2 * MARGIN + scale[0] * sizes[1][0], 2 * MARGIN + scale[1] * sizes[0][1]]),
    ]
    for k in range(3):
        flat[owner == k] = origins[k] + (flat[owner == k] - boxes[k][0]) * scale
    corners = np.round(flat.reshape(-1, 2), 6)
    keys = np.column_stack([quads.ravel(), corners])
    found, corner = np.unique(keys, axis=0, return_inverse=True)
    return found[:, 1:], corner.reshape(-1, 4), found[:, 0].astype(int)


def _area(quads: np.ndarray) -> float:
    p, q = quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]
    return (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum()
