"""Carries lines that are drawn on a body, in millimetres from a joint, into the texture, as strokes of docs/strokes.md."""

import json

import numpy as np
from scipy.interpolate import PchipInterpolator

from .part import Part

SAMPLES = 24  # points of a stroke
LEAP = 0.03  # of the texture: two neighbours further apart lie on either side of a seam
SHORTEST = 4  # points of a stroke that a seam has cut


class Chart:
    """A piece of skin spread out flat: two coordinates of every vertex, and which vertices belong to it."""

    def __init__(self, part: Part, flat: np.ndarray, belongs: np.ndarray):
        self._uv = part.uv
        self._triangles = part.triangles[belongs[part.triangles].all(axis=1)]
        self._corners = flat[self._triangles]

    def uv(self, points: np.ndarray) -> np.ndarray:
        """Where the points lie in the texture; nan beside the piece."""
        a, b, c = (self._corners[:, k] for k in range(3))
        area = _cross(b - a, c - a)
        found = np.full((len(points), 2), np.nan)
        for i, point in enumerate(points):
            with np.errstate(divide="ignore", invalid="ignore"):
                shares = np.stack([_cross(b - point, c - point), _cross(c - point, a - point), _cross(a - point, b - point)], 1) / area[:, None]
            inside = np.flatnonzero((shares >= -1e-9).all(axis=1))
            if len(inside):
                found[i] = shares[inside[0]] @ self._uv[self._triangles[inside[0]]]
        return found

    def stroke(self, group: str, points, width: float, depth: float, **more) -> list[dict]:
        """A smooth line through the points, in the chart's units, as none or one stroke; `width` and `depth` in millimetres."""
        points = np.array(points, float)
        steps = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        uv = self.uv(PchipInterpolator(steps, points)(np.linspace(0, steps[-1], SAMPLES)))
        whole = ~np.isnan(uv[:, 0])
        near = whole[1:] & whole[:-1] & (np.linalg.norm(np.diff(uv, axis=0), axis=1) < LEAP)
        runs = np.split(np.arange(SAMPLES), np.flatnonzero(~near) + 1)
        longest = max(runs, key=len)
        if len(longest) < SHORTEST:
            return []
        return [{"group": group, "points": np.round(uv[longest], 4).tolist(), "width": width, "depth": depth, **more}]


def document(strokes: list[dict], areas: list[dict], size: int) -> str:
    """JSON, one stroke or area a line."""
    lines = lambda items: ",\n".join("    " + json.dumps(item) for item in items)
    return f'{{\n  "version": 1,\n  "size": {size},\n  "strokes": [\n{lines(strokes)}\n  ],\n  "areas": [\n{lines(areas)}\n  ]\n}}\n'


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
