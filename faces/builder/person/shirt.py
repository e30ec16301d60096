"""Builds the neck of a shirt, which hides the cut edge of the skin."""

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree

from ..layout import borders
from ..part import Part, triangulate
from ..source import Mesh
from ..subdivide import catmull_clark, vertex_normals
from .head import NECK_RINGS, Head, regions

EASE = 2.5e-3  # distance between skin and cloth, metres
OVERLAP = 2  # number of rings of quads of the skin that the shirt covers
SMOOTH = 8.0  # standard deviation of the Gaussian that rounds the neckline, in vertices
REACH = 0.03  # distance from the neckline over which its rounding fades out, metres
BAND = 0.010  # width of a raised band along the neckline, metres
BAND_LIFT = 1.0e-3  # additional distance between skin and band, metres


def shirt_part(head: Head, mesh: Mesh, overlap=OVERLAP) -> Part:
    name, _ = regions(mesh, NECK_RINGS - overlap)
    used, quads = np.unique(mesh.quads[name == "shirt"], return_inverse=True)
    quads = quads.reshape(-1, 4)
    matrix, fine = catmull_clark(quads, len(used))
    body = matrix @ head.base[used]
    normals = vertex_normals(body, fine)

    neckline = max(borders(fine), key=lambda loop: body[loop, 1].mean())
    # Rounds the corners of the neckline, and moves the cloth near it by the same offsets.
    rounded = gaussian_filter1d(body[neckline], SMOOTH, axis=0, mode="wrap")
    gap, nearest = cKDTree(body[neckline]).query(body)
    t = np.clip(1 - gap / REACH, 0, 1)[:, None]
    draped = body + (rounded - body[neckline])[nearest] * t * t * (3 - 2 * t)

    # Moves each vertex of the cloth along the normal of the nearest point of the body. It then has the distance `lift`
    # from the point's tangent plane.
    surface = np.concatenate([body, head.positions])
    facing = np.concatenate([normals, head.normals])
    _, closest = cKDTree(surface).query(draped)
    lift = EASE + BAND_LIFT * np.clip((BAND - gap) / 2e-3, 0, 1)
    out = facing[closest]
    depth = ((draped - surface[closest]) * out).sum(axis=1)
    positions = draped + out * (lift - depth)[:, None]

    # Adds a hem that is folded inwards to the skin, so that the cloth looks thick at its edge.
    count, size = len(positions), len(neckline)
    inner = count + np.arange(size)
    positions = np.concatenate([positions, positions[neckline] - out[neckline] * (EASE + BAND_LIFT + 1.5e-3)])
    hem = np.stack([np.roll(neckline, -1), neckline, inner, np.roll(inner, -1)], axis=1)
    quads = np.concatenate([fine, hem])
    return Part("shirt", "shirt", positions, vertex_normals(positions, quads), None, triangulate(quads, positions))
