import numpy as np
import pytest

from builder.subdivide import catmull_clark, vertex_normals
from tests.shapes import cube, grid


def test_rows_sum_to_one():
    for positions, quads in (grid(3), cube()):
        matrix, _ = catmull_clark(quads, len(positions))
        assert np.asarray(matrix.sum(axis=1)).ravel() == pytest.approx(1)


def test_counts_of_a_cube():
    positions, quads = cube()
    matrix, fine = catmull_clark(quads, len(positions))
    assert matrix.shape == (8 + 12 + 6, 8)
    assert fine.shape == (24, 4)


def test_a_cube_follows_the_rule():
    positions, quads = cube()
    fine = catmull_clark(quads, len(positions))[0] @ positions
    # A corner P moves to (F + 2 * R + (n - 3) * P) / n. Here n = 3, the mean of the face points F is P / 3, and the
    # mean of the edge midpoints R is 2/3 * P.
    assert fine[:8] == pytest.approx(positions * (1 / 3 + 2 * 2 / 3) / 3)
    # An edge point is the mean of two ends and two face points: (1 + 1 + 1 + 0) / 4 on two axes, and 0 on the axis
    # along the edge.
    assert np.sort(np.abs(fine[8:20]), axis=1) == pytest.approx(np.tile([0, 0.75, 0.75], (12, 1)))
    assert np.sort(np.abs(fine[20:]), axis=1) == pytest.approx(np.tile([0, 0, 1], (6, 1)))


def test_a_flat_sheet_stays_flat_and_keeps_its_corners():
    positions, quads = grid(2)
    fine = catmull_clark(quads, len(positions))[0] @ positions
    assert fine[:, 2] == pytest.approx(0)
    for corner in (0, 2, 6, 8):
        assert fine[corner] == pytest.approx(positions[corner])
    # The middle vertex of a regular grid does not move.
    assert fine[4] == pytest.approx([0.5, 0.5, 0])
    assert fine[1] == pytest.approx([0.5, 0, 0])


def test_fine_quads_keep_their_order_and_orientation():
    positions, quads = grid(2)
    matrix, fine = catmull_clark(quads, len(positions))
    points = matrix @ positions
    centres = points[fine].mean(axis=1).reshape(4, 4, 3).mean(axis=1)
    assert centres == pytest.approx(positions[quads].mean(axis=1), abs=0.05)
    assert vertex_normals(points, fine)[:, 2] == pytest.approx(1)


def test_normals_of_a_cube_point_to_its_corners():
    positions, quads = cube()
    assert vertex_normals(positions, quads) == pytest.approx(positions / np.sqrt(3))


def test_a_vertex_without_quads_has_no_normal():
    positions, quads = grid(1)
    normals = vertex_normals(np.vstack([positions, [5, 5, 5]]), quads)
    assert normals[-1].tolist() == [0, 0, 0]
