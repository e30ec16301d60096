import numpy as np
import pytest

from builder.raster import Atlas
from tests.shapes import sheet_part


def test_texels_interpolate_at_their_centres():
    part = sheet_part()
    atlas = Atlas(part.uv, part.triangles, 16)
    assert atlas.covered.all()
    centres = (np.arange(16) + 0.5) / 16
    u, v = np.meshgrid(centres, centres)
    assert atlas.spread(part.uv[:, 0]) == pytest.approx(u)
    assert atlas.spread(part.uv) == pytest.approx(np.stack([u, v], axis=2))


def test_texels_outside_have_the_value_of_the_nearest_one():
    part = sheet_part()
    part.uv = part.uv / 2  # covers the upper left quarter of the texture
    atlas = Atlas(part.uv, part.triangles, 16)
    assert atlas.covered.sum() == 64
    values = atlas.spread(part.uv[:, 0])
    assert (values[:8, 8:] == values[:8, 7:8]).all()
    assert (values[8:] == values[7]).all()


def test_triangles_without_area_cover_nothing():
    uv = np.array([[0.1, 0.1], [0.5, 0.5], [0.9, 0.9], [0, 0], [1, 0], [0, 1]])
    atlas = Atlas(uv, np.array([[0, 1, 2], [3, 4, 5]]), 8)
    assert atlas.spread(np.array([9.0, 9, 9, 1, 1, 1])) == pytest.approx(1)
