import numpy as np

from builder.joints.neck import ROWS, ROWS_BACK, _solved, spread_map
from builder.person.head import thin_out
from builder.subdivide import catmull_clark
from tests.shapes import grid


def test_thinned_quads_leave_no_gap_beside_fine_ones():
    positions, quads = grid(2)
    matrix, fine = catmull_clark(quads, len(positions))
    points = matrix @ positions
    # The lower half is the neck, which gets fewer triangles.
    is_neck = positions[quads].mean(axis=1)[:, 1] < 0.5
    fine = fine.reshape(-1, 4, 4)
    triangles = thin_out(fine[is_neck], np.unique(fine[~is_neck]))
    border = np.unique(fine[~is_neck][points[fine[~is_neck]][..., 1] == 0.5])
    assert np.isin(border, triangles).all()
    a, b, c = points[triangles].transpose(1, 0, 2)
    areas = np.cross(b - a, c - a)[:, 2] / 2
    # The lower half of the unit square has an area of 0.5. Subdivision rounds its borders, so the area is smaller.
    assert (areas > 0).all()
    assert abs(areas.sum() - 0.5) < 0.01
    assert len(triangles) == 2 * 3  # two quads with five corners each


def test_rows_of_the_neck_are_inverted():
    v = np.linspace(0, 1, 101)
    assert np.abs(ROWS(_solved(v)) - v).max() < 1e-12
    assert np.abs(ROWS_BACK(v) - _solved(v)).max() < 0.02


def test_maps_of_the_face_are_stretched():
    v = (np.arange(256) + 0.5) / 256
    image = np.tile(v[:, None, None], (1, 4, 3))
    assert np.abs(spread_map(image)[:, 0, 0] - ROWS(v)).max() < 1 / 256
