import numpy as np

from builder.part import triangulate


def test_quads_are_cut_along_the_shorter_diagonal():
    # The shorter diagonal of this parallelogram goes from its second to its fourth corner.
    positions = np.array([[0, 0, 0], [2, 0, 0], [3, 1, 0], [1, 1, 0]], float)
    assert triangulate(np.array([[0, 1, 2, 3]]), positions).tolist() == [[0, 1, 3], [1, 2, 3]]
    positions[:, 0] *= -1
    assert triangulate(np.array([[3, 0, 1, 2]]), positions).tolist() == [[3, 0, 1], [3, 1, 2]]


def test_triangles_face_as_their_quad():
    rng = np.random.default_rng(0)
    flat = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) + rng.uniform(-0.2, 0.2, (50, 4, 2))
    positions = np.concatenate([flat.reshape(-1, 2), np.zeros((200, 1))], axis=1)
    a, b, c = positions[triangulate(np.arange(200).reshape(-1, 4), positions)].transpose(1, 0, 2)
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()
