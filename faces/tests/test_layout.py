import numpy as np

from builder.layout import borders
from builder.subdivide import catmull_clark
from tests.shapes import cube, grid


def test_a_closed_mesh_has_no_border():
    assert borders(cube()[1]) == []


def test_a_sheet_has_one_loop_along_its_quads():
    _, quads = grid(2)
    (loop,) = borders(quads)
    assert sorted(loop.tolist()) == [0, 1, 2, 3, 5, 6, 7, 8]
    edges = {(a, b) for quad in quads.tolist() for a, b in zip(quad, quad[1:] + quad[:1], strict=True)}
    assert all(edge in edges for edge in zip(loop.tolist(), np.roll(loop, -1).tolist(), strict=True))


def test_loops_are_shortest_first():
    quads = np.delete(grid(5)[1], 12, axis=0)
    assert [len(loop) for loop in borders(quads)] == [4, 20]


def test_a_loop_doubles_when_its_mesh_is_subdivided():
    positions, quads = grid(3)
    _, fine = catmull_clark(quads, len(positions))
    assert len(borders(fine)[0]) == 2 * len(borders(quads)[0])
