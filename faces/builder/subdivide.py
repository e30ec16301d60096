"""Subdivides quad meshes and computes smooth vertex normals.

E. Catmull, J. Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", 1978. Subdivision is
linear, so it is represented by a sparse matrix, which can be applied to positions, displacements and weights.
"""

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix, identity, vstack


def catmull_clark(quads: np.ndarray, count: int) -> tuple[csr_matrix, np.ndarray]:
    """Subdivides quads (f, 4) over `count` vertices once.

    Returns a sparse matrix (new vertices x old vertices) that computes values of new vertices, and the new quads
    (4f, 4). New vertices are ordered: moved old vertices, edge points, face points. The four new quads of an old quad
    are consecutive, and each starts with a corner of the old quad. Open borders become cubic B-splines. A vertex that
    belongs to a single quad does not move.
    """
    faces = len(quads)
    starts = quads.ravel()
    ends = np.roll(quads, -1, axis=1).ravel()
    keys = np.sort(np.stack([starts, ends], 1), axis=1)
    edges, edge_of, uses = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    edge_of = edge_of.reshape(faces, 4)
    border = uses == 1

    face_ids = np.repeat(np.arange(faces), 4)
    face_point = _table(0.25, face_ids, starts, (faces, count))

    # An edge point is the mean of both ends of the edge and both adjacent face points. On a border it is the mean of
    # both ends.
    edge_ids = np.repeat(np.arange(len(edges)), 2)
    ends_mean = _table(0.5, edge_ids, edges.ravel(), (len(edges), count))
    faces_mean = _table(0.5, edge_of.ravel(), face_ids, (len(edges), faces)) @ face_point
    inner = (~border).astype(float)
    edge_point = _scale(ends_mean, 1 - 0.5 * inner) + _scale(faces_mean, 0.5 * inner)

    # An old vertex with n quads, inside the mesh, moves to
    # (mean of face points + 2 * mean of edge midpoints + (n - 3) * vertex) / n.
    valence = np.maximum(np.bincount(starts, minlength=count), 1)
    spokes = np.maximum(np.bincount(edges.ravel(), minlength=count), 1)
    around_faces = _scale(_table(1, starts, face_ids, (count, faces)) @ face_point, 1 / valence)
    around_edges = _scale(_table(1, edges.ravel(), edge_ids, (count, len(edges))) @ ends_mean, 1 / spokes)
    itself = identity(count, format="csr")
    inside = (
        _scale(around_faces, 1 / valence) + _scale(around_edges, 2 / valence) + _scale(itself, (valence - 3) / valence)
    )

    # An old vertex on a border moves to 3/4 * vertex + 1/8 * (sum of both neighbours along the border).
    border_edges = edges[border]
    along = _table(0.125, border_edges.ravel(), border_edges[:, ::-1].ravel(), (count, count))
    on_border = np.bincount(border_edges.ravel(), minlength=count) > 0
    corner = on_border & (np.bincount(starts, minlength=count) == 1)
    smooth_border = on_border & ~corner
    vertex_point = (
        _scale(inside, (~on_border).astype(float))
        + _scale(along, smooth_border.astype(float))
        + _scale(itself, 0.75 * smooth_border + 1.0 * corner)
    )

    matrix = vstack([vertex_point, edge_point, face_point]).tocsr()
    edge_id, face_id = count + edge_of, count + len(edges) + np.arange(faces)
    new = [np.stack([quads[:, i], edge_id[:, i], face_id, edge_id[:, (i + 3) % 4]], axis=1) for i in range(4)]
    return matrix, np.stack(new, axis=1).reshape(-1, 4)


def _table(value: float, rows: np.ndarray, cols: np.ndarray, shape: tuple[int, int]) -> csr_matrix:
    return coo_matrix((np.full(len(rows), float(value)), (rows, cols)), shape).tocsr()


def _scale(matrix, weights) -> csr_matrix:
    return csr_matrix(matrix.multiply(np.asarray(weights, dtype=float)[:, None]))


def vertex_normals(positions: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """Returns the unit normals of vertices, averaged over their quads and weighted by area.

    The area is proportional to the length of the cross product of a quad's diagonals.
    """
    a, b, c, d = (positions[quads[:, i]] for i in range(4))
    face = np.cross(c - a, d - b)
    total = np.stack(
        [np.bincount(quads.ravel(), np.repeat(face[:, k], 4), minlength=len(positions)) for k in range(3)], axis=1
    )
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.divide(total, length, out=np.zeros_like(total), where=length > 0)
