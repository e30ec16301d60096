"""A round-neck shirt that hides the cut edge of the neck."""

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree

from ..layout import borders
from ..part import Part, triangulate
from ..source import Mesh
from ..subdivide import catmull_clark, vertex_normals
from .head import NECK_RINGS, Head, regions

EASE = 2.5e-3  # metres between skin and cloth
OVERLAP = 2  # rings of skin covered by the shirt
SMOOTH = 8.0  # deviation of the Gaussian that rounds the neckline, in vertices
REACH = 0.03  # metres below the neckline over which the rounding fades
BAND = 0.010  # width in metres of the neckline that is lifted more
BAND_LIFT = 1.0e-3


def shirt_part(head: Head, mesh: Mesh, overlap=OVERLAP) -> Part:
    name, _ = regions(mesh, NECK_RINGS - overlap)
    used, quads = np.unique(mesh.quads[name == "shirt"], return_inverse=True)
    quads = quads.reshape(-1, 4)
    matrix, fine = catmull_clark(quads, len(used))
    body = matrix @ head.base[used]
    normals = vertex_normals(body, fine)

    neckline = max(borders(fine), key=lambda loop: body[loop, 1].mean())
    # Rounds the corners of the neckline; the cloth follows.
    rounded = gaussian_filter1d(body[neckline], SMOOTH, axis=0, mode="wrap")
    gap, nearest = cKDTree(body[neckline]).query(body)
    t = np.clip(1 - gap / REACH, 0, 1)[:, None]
    draped = body + (rounded - body[neckline])[nearest] * t * t * (3 - 2 * t)

    # Moves the cloth back to the tangent plane of the nearest body point, plus the ease.
    surface = np.concatenate([body, head.positions])
    facing = np.concatenate([normals, head.normals])
    _, closest = cKDTree(surface).query(draped)
    lift = EASE + BAND_LIFT * np.clip((BAND - gap) / 2e-3, 0, 1)
    out = facing[closest]
    depth = ((draped - surface[closest]) * out).sum(axis=1)
    positions = draped + out * (lift - depth)[:, None]

    # A hem turned in to the skin gives the cloth an edge.
    count, size = len(positions), len(neckline)
    inner = count + np.arange(size)
    positions = np.concatenate([positions, positions[neckline] - out[neckline] * (EASE + BAND_LIFT + 1.5e-3)])
    hem = np.stack([np.roll(neckline, -1), neckline, inner, np.roll(inner, -1)], axis=1)
    quads = np.concatenate([fine, hem])
    return Part("shirt", "shirt", positions, vertex_normals(positions, quads), None, triangulate(quads, positions))
