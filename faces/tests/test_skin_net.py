import numpy as np
import pytest
from scipy.spatial import cKDTree

from builder.person.fields import Fields
from builder.person.skin_net import area_of_texels, scattered, skin_net
from builder.raster import Atlas
from tests.shapes import sheet_part


@pytest.fixture(scope="module")
def fields():
    part = sheet_part()
    return Fields(Atlas(part.uv, part.triangles, 128), part.positions, seed=3)


def plateaus(fields, spacing):
    return scattered(fields, np.full((fields.size, fields.size), spacing))


def test_plateaus_keep_their_distance_and_leave_no_gaps(fields):
    points = plateaus(fields, 0.06)
    gaps, _ = cKDTree(points).query(points, k=2)
    assert gaps[:, 1].min() >= 0.8 * 0.06
    distances, _ = cKDTree(points).query(fields.space[fields.near])
    assert distances.max() < 0.06 * 1.2


def test_half_the_spacing_makes_four_times_the_plateaus(fields):
    assert len(plateaus(fields, 0.04)) / len(plateaus(fields, 0.08)) == pytest.approx(4, rel=0.25)


def test_texels_cover_the_area_of_the_sheet(fields):
    assert area_of_texels(fields.space)[fields.near].sum() == pytest.approx(1, rel=0.1)


def test_pores_lie_in_furrows_and_furrows_surround_plateaus(fields):
    spacing = np.full((fields.size, fields.size), 0.1)
    furrows, pores = skin_net(fields, spacing, width=0.4)
    for values in (furrows, pores):
        assert values.min() == 0
        assert values.max() <= 1
    assert (pores <= furrows).all()
    covered = (furrows > 0).mean()
    assert 0.2 < covered < 0.8
    assert 0 < (pores > 0).mean() < covered


def test_the_net_is_the_same_every_time(fields):
    assert (plateaus(fields, 0.06) == plateaus(fields, 0.06)).all()
