"""Texture layout of the skin: the head's UV island of MakeHuman's mesh (the source), upright in the unit square.

As an image it shows the person from the front: forehead up, the person's left on the right, symmetric about u = 0.5.
The source gives eyelids and lips too few texels for wrinkles. Therefore the interior is relaxed until texels are nearly
even over the skin, and denser on the face. The outline stays, with the back of the head compressed.
"""

import numpy as np
from scipy.sparse import coo_matrix, diags, identity
from scipy.sparse.linalg import spsolve

FOCUS = 3.0  # u = asinh(FOCUS x) / asinh(FOCUS) enlarges the face and compresses the nape
HEAD_BOTTOM = 0.93  # v of the source island's lower end; the neck is below
ROUNDS = 3  # rounds of relaxation; a fourth would fold quads at the nostrils
FACE_CENTRE = np.array([0.0, 0.735, 0.15])  # metres, on the source's unblended base figure
FACE_SIZE = 0.085  # metres
FACE_GAIN = 1.0  # added texel density in the middle of the face


def skin_layout(source: np.ndarray, quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Returns uv (n, 2), v down.

    `source` (n, 2): texture coordinates of the source, forehead left, v up. The neck has none, so they are nan there.
    `quads`: vertex indices. `positions` (n, 3): vertices of the symmetric base figure, so that all recipes share a
    layout.
    """
    uv = _upright(source)
    loops = borders(quads)
    outline, holes = loops[-1], loops[:-1]
    uv[outline] = _close_outline(uv[outline], positions[outline])

    # Triangle fans close the openings of eyes and mouth, so that the relaxation moves their edges too.
    a, b, c, d = quads.T
    triangles = [np.stack(t, 1) for t in ((a, b, c), (a, c, d), (a, b, d), (b, c, d))]  # both diagonals, for symmetry
    points = [positions]
    for hole in holes:
        centre = np.full(len(hole), sum(map(len, points)))
        triangles.append(np.stack([np.roll(hole, -1), hole, centre], 1))
        points.append(positions[hole].mean(axis=0, keepdims=True))
    triangles, points = np.concatenate(triangles), np.concatenate(points)

    count = len(points)
    held = np.zeros(count, dtype=bool)
    held[outline] = True
    uvs = np.zeros((count, 2))
    uvs[: len(uv)] = uv
    rows, cols, weights = _mean_value_weights(points, triangles)
    density = 1 + FACE_GAIN * np.exp(-((points - FACE_CENTRE) ** 2).sum(axis=1) / FACE_SIZE**2)
    slack = np.ones(count)
    # S. Yoshizawa, A. Belyaev, H.-P. Seidel, "A fast and simple stretch-minimizing mesh parameterization", 2004:
    # repeatedly solves, and weakens springs around vertices with large stretch.
    for _ in range(ROUNDS + 1):
        spring = coo_matrix((weights / slack[cols], (rows, cols)), (count, count)).tocsr()
        spring = diags(1 / np.asarray(spring.sum(axis=1)).ravel()) @ spring
        system = (identity(count) - spring).tocsc()[~held]
        right = -(system[:, held] @ uvs[held])
        uvs[~held] = np.stack([spsolve(system[:, ~held], right[:, k]) for k in (0, 1)], axis=1)
        stretch = _stretch(points, uvs, triangles) * density
        slack *= np.sqrt(np.clip(stretch / np.median(stretch), 0.2, 5))
    return uvs[: len(uv)]


def _upright(source: np.ndarray) -> np.ndarray:
    lowest = source[np.nanargmax(source[:, 0]), 1]  # under the chin, on the line of symmetry
    across = source[:, 1] - lowest
    u = 0.5 + 0.5 * np.arcsinh(FOCUS * across / np.nanmax(np.abs(across))) / np.arcsinh(FOCUS)
    down = source[:, 0] - np.nanmin(source[:, 0])
    return np.stack([u, HEAD_BOTTOM * down / np.nanmax(down)], axis=1)


def _close_outline(uv: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Adds the neck to the outline: the nape's seam down both sides of the square, the collar along the bottom."""
    neck = np.isnan(uv[:, 0])
    first = np.flatnonzero(neck & ~np.roll(neck, 1))[0]
    order = np.roll(
        np.arange(len(uv)), 1 - first
    )  # starts with the last vertex of the seam that has texture coordinates
    run = order[: neck.sum() + 2]  # ends with the vertex's twin on the other side
    gaps = np.linalg.norm(np.diff(positions[run], axis=0), axis=1)
    foot = np.flatnonzero(
        np.abs(positions[run, 0]) < 1e-6
    )  # vertices on the midline: the ends of both seams, and the front of the collar
    collar = np.array([i for i in foot if positions[run[i], 2] < 0 and neck[run[i]]])
    start, end = collar[len(collar) // 2 - 1], collar[len(collar) // 2]
    along = np.concatenate([[0], np.cumsum(gaps)])

    def fractions(a, b):
        return (along[a : b + 1] - along[a]) / (along[b] - along[a])

    uvs = uv.copy()
    (u0, v0), (u1, v1) = uv[run[0]], uv[run[-1]]
    uvs[run[: start + 1]] = np.stack([np.full(start + 1, u0), v0 + (1 - v0) * fractions(0, start)], 1)
    uvs[run[start : end + 1]] = np.stack([u0 + (u1 - u0) * fractions(start, end), np.ones(end - start + 1)], 1)
    rest = len(run) - 1
    uvs[run[end:]] = np.stack([np.full(rest - end + 1, u1), 1 - (1 - v1) * fractions(end, rest)], 1)
    return uvs


def borders(quads: np.ndarray) -> list[np.ndarray]:
    """Finds loops of border edges, shortest first."""
    edges = np.stack([quads.ravel(), np.roll(quads, -1, axis=1).ravel()], 1)
    _, which, uses = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True)
    after = dict(edges[uses[which.ravel()] == 1].tolist())
    loops = []
    while after:
        at = min(after)
        loop = []
        while at in after:
            loop.append(at)
            at = after.pop(at)
        loops.append(np.array(loop))
    return sorted(loops, key=len)


def _mean_value_weights(points, triangles):
    """M. Floater, "Mean value coordinates", 2003. Positive weights keep vertices between their neighbours."""
    rows, cols, weights = [], [], []
    for k in range(3):
        i, j, m = (triangles[:, (k + s) % 3] for s in range(3))
        a, b = points[j] - points[i], points[m] - points[i]
        long_a, long_b = (np.maximum(np.linalg.norm(x, axis=1), 1e-7) for x in (a, b))
        angle = np.arccos(np.clip((a * b).sum(axis=1) / long_a / long_b, -0.999, 0.999))
        rows += [i, i]
        cols += [j, m]
        weights += [np.tan(angle / 2) / long_a, np.tan(angle / 2) / long_b]
    return np.concatenate(rows), np.concatenate(cols), np.concatenate(weights)


def _stretch(points, uvs, triangles) -> np.ndarray:
    """Returns metres on the skin per unit of uv, (n,): root mean square over directions and triangles."""

    def edge(x, k):
        return x[triangles[:, k]] - x[triangles[:, 0]]

    in_space = np.stack([edge(points, 1), edge(points, 2)], axis=2)
    in_layout = np.stack([edge(uvs, 1), edge(uvs, 2)], axis=2)
    per_triangle = np.sqrt(((in_space @ np.linalg.pinv(in_layout)) ** 2).sum(axis=(1, 2)) / 2)
    area = np.linalg.norm(np.cross(in_space[..., 0], in_space[..., 1]), axis=1)

    def sum_at(x):
        return np.bincount(triangles.ravel(), np.repeat(x, 3), minlength=len(points))

    return sum_at(area * per_triangle) / sum_at(area)
