"""Computes the texture layout of the head's skin from the layout of MakeHuman's mesh, the source.

The layout fills the unit square and is symmetric about u = 0.5. As an image, it shows the person from the front:
forehead up, the person's left on the right. In the source's layout, eyelids and lips have too few texels for wrinkles.
Therefore all vertices inside the layout's outline are moved, until texels cover nearly equal areas of skin. Only the
middle of the face has more texels.
"""

import numpy as np
from scipy.sparse import coo_matrix, diags, identity
from scipy.sparse.linalg import spsolve

# Enlarges the face and compresses the nape: x becomes asinh(FOCUS * x) / asinh(FOCUS). Across the head, x is 0 at the
# middle of the face, and -1 or 1 at the seam at the nape.
FOCUS = 3.0
HEAD_BOTTOM = 0.93  # v of the lower end of the head; the neck is below
ROUNDS = 3  # rounds of relaxation; a fourth would fold quads at the nostrils
FACE_CENTRE = np.array([0.0, 0.735, 0.15])  # metres, on the source's base figure
FACE_SIZE = 0.085  # radius of the region with more texels, metres
FACE_GAIN = 1.0  # relative increase of texels per metre in the middle of the face


def skin_layout(source: np.ndarray, quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Returns texture coordinates (n, 2), v down.

    `source` (n, 2): texture coordinates of the source, forehead left, v up. They are nan on the neck. `quads` (f, 4):
    vertex indices. `positions` (n, 3): vertices of the symmetric base figure. The shape of a person is not used, so
    all people have the same layout.
    """
    uv = _upright(source)
    loops = borders(quads)
    outline, holes = loops[-1], loops[:-1]
    uv[outline] = _close_outline(uv[outline], positions[outline])

    # Triangle fans close the openings of eyes and mouth, so that the relaxation moves their edges too.
    a, b, c, d = quads.T
    # Each quad is cut along both diagonals, so that the result is symmetric.
    triangles = [np.stack(t, 1) for t in ((a, b, c), (a, c, d), (a, b, d), (b, c, d))]
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
    # S. Yoshizawa, A. Belyaev, H.-P. Seidel, "A fast and simple stretch-minimizing mesh parameterization", 2004. Each
    # round solves for the texture coordinates, and then reduces the weights of vertices with large stretch.
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
    # The lowest vertex is under the chin, on the line of symmetry.
    symmetry = source[np.nanargmax(source[:, 0]), 1]
    across = source[:, 1] - symmetry
    u = 0.5 + 0.5 * np.arcsinh(FOCUS * across / np.nanmax(np.abs(across))) / np.arcsinh(FOCUS)
    down = source[:, 0] - np.nanmin(source[:, 0])
    return np.stack([u, HEAD_BOTTOM * down / np.nanmax(down)], axis=1)


def _close_outline(uv: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Completes the outline of the layout with texture coordinates for the border of the neck.

    The seam at the nape goes down both sides of the square. The lower edge of the neck, the collar, goes along the
    bottom of the square.
    """
    neck = np.isnan(uv[:, 0])
    first = np.flatnonzero(neck & ~np.roll(neck, 1))[0]
    # `run`: vertices along the outline of the neck. It starts with the last vertex of the seam that has texture
    # coordinates, and ends with the same vertex on the other side of the seam.
    order = np.roll(np.arange(len(uv)), 1 - first)
    run = order[: neck.sum() + 2]
    gaps = np.linalg.norm(np.diff(positions[run], axis=0), axis=1)
    # `foot`: indices into `run` of the vertices in the plane of symmetry. They are on the seam, or at the front of the
    # collar. `collar`: those of the seam. Its two middle elements are the lower ends of the seam's sides.
    foot = np.flatnonzero(np.abs(positions[run, 0]) < 1e-6)
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
    """Returns the loops of border edges as arrays of vertices, shortest first."""
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
    """Returns mean value weights (M. Floater, "Mean value coordinates", 2003) as rows, columns and values of a matrix.

    The weights are positive, which keeps each vertex between its neighbours.
    """
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
    """Returns the stretch at each vertex, (n,): metres on the skin per unit of uv, averaged over its triangles."""

    def edge(x, k):
        return x[triangles[:, k]] - x[triangles[:, 0]]

    in_space = np.stack([edge(points, 1), edge(points, 2)], axis=2)
    in_layout = np.stack([edge(uvs, 1), edge(uvs, 2)], axis=2)
    per_triangle = np.sqrt(((in_space @ np.linalg.pinv(in_layout)) ** 2).sum(axis=(1, 2)) / 2)
    area = np.linalg.norm(np.cross(in_space[..., 0], in_space[..., 1]), axis=1)

    def sum_at(x):
        return np.bincount(triangles.ravel(), np.repeat(x, 3), minlength=len(points))

    return sum_at(area * per_triangle) / sum_at(area)
