"""Converts crease lines from coordinates on the body to strokes in the texture (docs/strokes-format.md)."""

import json

import numpy as np
from scipy.interpolate import PchipInterpolator

from ..part import Part

SAMPLES = 24  # points per stroke
LEAP = 0.03  # uv; if consecutive samples are further apart, a UV seam lies between them
MIN_POINTS = 4  # minimum number of points of a stroke


class Chart:
    """A flattened region of the skin, in which lines are drawn.

    `flat` (n, 2): coordinates in the region for all vertices. `belongs` (n,): mask of the vertices in the region.
    """

    def __init__(self, part: Part, flat: np.ndarray, belongs: np.ndarray):
        self._uv = part.uv
        self._triangles = part.triangles[belongs[part.triangles].all(axis=1)]
        self._corners = flat[self._triangles]

    def uv(self, points: np.ndarray) -> np.ndarray:
        """Converts points (n, 2) from the chart's coordinates to uv (n, 2). Points outside the region become nan."""
        a, b, c = (self._corners[:, k] for k in range(3))
        area = _cross(b - a, c - a)
        found = np.full((len(points), 2), np.nan)
        for i, point in enumerate(points):
            with np.errstate(divide="ignore", invalid="ignore"):
                barycentrics = (
                    np.stack(
                        [_cross(b - point, c - point), _cross(c - point, a - point), _cross(a - point, b - point)], 1
                    )
                    / area[:, None]
                )
            inside = np.flatnonzero((barycentrics >= -1e-9).all(axis=1))
            if len(inside):
                found[i] = barycentrics[inside[0]] @ self._uv[self._triangles[inside[0]]]
        return found

    def stroke(self, group: str, points, width: float, depth: float, **more) -> list[dict]:
        """Draws a smooth line through `points` in the chart's coordinates. `width` and `depth` are in millimetres.

        UV seams and the region's edge can cut the line. Returns a list with the longest piece as a stroke, or an empty
        list if this piece has fewer than `MIN_POINTS` points.
        """
        points = np.array(points, float)
        steps = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        uv = self.uv(PchipInterpolator(steps, points)(np.linspace(0, steps[-1], SAMPLES)))
        valid = ~np.isnan(uv[:, 0])
        near = valid[1:] & valid[:-1] & (np.linalg.norm(np.diff(uv, axis=0), axis=1) < LEAP)
        runs = np.split(np.arange(SAMPLES), np.flatnonzero(~near) + 1)
        longest = max(runs, key=len)
        if len(longest) < MIN_POINTS:
            return []
        return [{"group": group, "points": np.round(uv[longest], 4).tolist(), "width": width, "depth": depth, **more}]


def document(strokes: list[dict], areas: list[dict], size: int) -> str:
    """Formats a strokes document as JSON. Each stroke and each area is on one line."""

    def lines(items):
        return ",\n".join("    " + json.dumps(item) for item in items)

    return (
        f'{{\n  "version": 1,\n  "size": {size},\n  "strokes": [\n{lines(strokes)}\n  ],\n'
        f'  "areas": [\n{lines(areas)}\n  ]\n}}\n'
    )


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
