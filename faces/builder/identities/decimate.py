"""Simplifies a mesh by collapsing edges.

M. Garland, P. Heckbert, "Surface simplification using quadric error metrics", 1997. Each collapse moves one end of an
edge to the other end, so remaining vertices keep their positions and attributes. Vertices on borders and UV seams are
kept.
"""

import heapq
from dataclasses import replace

import numpy as np

from ..part import Part

MOTION_COST = 3.0  # added to the cost factor of a vertex that a target moves by `MOTION`
MOTION = 5e-3  # metres
SHORT = 1e-9  # cost of a collapse per squared edge length
MIN_COSINE = 0.3  # minimum cosine between a triangle's normals before and after a collapse


def decimate(part: Part, count: int) -> Part:
    """Reduces a part to `count` vertices. Stops earlier if every further collapse would flip a triangle."""
    moves = [np.linalg.norm(shift, axis=1) for shift, _ in part.targets.values()]
    motion = np.clip(np.max(moves, axis=0) / MOTION, 0, 2) if moves else np.zeros(len(part.positions))
    triangles = _collapsed(part.positions, part.uv, part.triangles, 1 + MOTION_COST * motion, count)
    kept, index = np.unique(triangles, return_inverse=True)

    def at(values):
        return None if values is None else values[kept]

    return replace(
        part,
        positions=part.positions[kept],
        normals=part.normals[kept],
        uv=at(part.uv),
        colours=at(part.colours),
        triangles=index.reshape(-1, 3),
        targets={name: (shift[kept], at(turn)) for name, (shift, turn) in part.targets.items()},
    )


def _collapsed(positions, uv, triangles, weights, count) -> np.ndarray:
    faces = {i: tuple(t) for i, t in enumerate(triangles.tolist())}
    around = [set() for _ in positions]  # faces around each vertex
    for i, face in faces.items():
        for v in face:
            around[v].add(i)
    normal = np.cross(
        positions[triangles[:, 1]] - positions[triangles[:, 0]], positions[triangles[:, 2]] - positions[triangles[:, 0]]
    )
    area = np.linalg.norm(normal, axis=1, keepdims=True)
    unit = np.divide(normal, area, out=np.zeros_like(normal), where=area > 0)
    plane = np.c_[unit, -(unit * positions[triangles[:, 0]]).sum(axis=1)]
    quadric = np.zeros((len(positions), 4, 4))
    for k in range(3):
        np.add.at(quadric, triangles[:, k], plane[:, :, None] * plane[:, None, :] * area[:, :, None])
    quadric *= weights[:, None, None]
    homogeneous = np.c_[positions, np.ones(len(positions))]
    border = _border(triangles, len(positions))
    remaining = sum(map(bool, around))
    version = [0] * len(positions)

    def neighbours(v):
        return {w for face in around[v] for w in faces[face]} - {v}

    def best(v):
        """Returns the cheapest collapse of vertex `v`: its cost and the neighbour, or None if none is allowed."""
        near = neighbours(v)
        order = sorted(near)
        ends = homogeneous[order]
        # The second term prefers short edges on flat surfaces.
        reach = ((ends - homogeneous[v]) ** 2).sum(axis=1)
        costs = np.einsum("ni,ij,nj->n", ends, quadric[v], ends) + SHORT * weights[v] * reach
        options = zip(costs.tolist(), order, strict=True)
        for cost, w in sorted(options):
            if len(near & neighbours(w)) == 2 and _keeps_shape(v, w, around, faces, positions, uv):
                return cost, w
        return None

    heap = []

    def push(v):
        version[v] += 1
        if not border[v] and around[v]:
            found = best(v)
            if found:
                heapq.heappush(heap, (found[0], v, found[1], version[v]))

    for v in range(len(positions)):
        push(v)
    while remaining > count and heap:
        _, v, w, stamp = heapq.heappop(heap)
        if stamp != version[v]:
            continue
        touched = neighbours(v)
        for face in list(around[v]):
            corners = faces[face]
            for c in corners:
                around[c].discard(face)
            if w in corners:
                del faces[face]
            else:
                faces[face] = tuple(w if c == v else c for c in corners)
                for c in faces[face]:
                    around[c].add(face)
        quadric[w] += quadric[v]
        remaining -= 1
        for x in touched:
            push(x)
    return np.array(list(faces.values()))


def _border(triangles, count) -> np.ndarray:
    edges = np.sort(np.stack([triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()], 1), axis=1)
    edges, uses = np.unique(edges, axis=0, return_counts=True)
    found = np.zeros(count, bool)
    found[edges[uses == 1].ravel()] = True
    return found


def _keeps_shape(v, w, around, faces, positions, uv) -> bool:
    """Returns whether collapsing `v` into `w` flips no triangle, neither in space nor in the texture layout."""
    kept = [faces[f] for f in around[v] if w not in faces[f]]
    before = np.array(kept).reshape(-1, 3)
    after = np.where(before == v, w, before)
    a, b = (_normals(positions, t) for t in (before, after))
    turn = (a * b).sum(axis=1)
    if (turn <= MIN_COSINE * np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)).any():
        return False
    if uv is None:
        return True
    # Triangles in the texture layout must neither be mirrored nor nearly vanish.
    old, new = (_areas(uv, t) for t in (before, after))
    return bool((np.sign(old) * new > 1e-8).all())


def _normals(points, t):
    return np.cross(points[t[:, 1]] - points[t[:, 0]], points[t[:, 2]] - points[t[:, 0]])


def _areas(uv, t):
    a, b = uv[t[:, 1]] - uv[t[:, 0]], uv[t[:, 2]] - uv[t[:, 0]]
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
