"""Computes MikkTSpace tangents (M. S. Mikkelsen, 2008) for parts without mirrored uv."""

import numpy as np

from .part import Part


def tangents(part: Part) -> np.ndarray:
    """Returns tangents (n, 4): xyz is the direction of increasing u, and w is 1.

    The bitangent points up in the image and equals `cross(normal, tangent)`. The tangents of the triangles around a
    vertex are projected into the vertex's tangent plane, and averaged with the triangles' angles as weights.

    Raises ValueError if a triangle is mirrored in uv.
    """
    up = part.uv * [1, -1]
    corners = part.triangles
    p, t = part.positions[corners], up[corners]
    first, second = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    a, b = t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    if (area < 0).any():
        raise ValueError(f"tangents: mirrored triangles in {part.name}, got {np.sum(area < 0)}, allowed: 0")
    along = _unit(b[:, 1:] * first - a[:, 1:] * second)
    total = np.zeros_like(part.positions)
    for k in range(3):
        vertex = corners[:, k]
        normal = part.normals[vertex]
        sides = [_into_plane(p[:, (k + i) % 3] - p[:, k], normal) for i in (1, 2)]
        angle = np.arccos(np.clip(np.sum(sides[0] * sides[1], axis=1, keepdims=True), -1, 1))
        np.add.at(total, vertex, angle * _into_plane(along, normal))
    return np.concatenate([_unit(total), np.ones((len(total), 1))], axis=1)


def _into_plane(vectors: np.ndarray, normals: np.ndarray) -> np.ndarray:
    return _unit(vectors - normals * np.sum(normals * vectors, axis=1, keepdims=True))


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-20)
