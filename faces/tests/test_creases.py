import json

import numpy as np
import pytest

from builder.joints.creases import LEAP, SAMPLES, Chart, document
from tests.shapes import sheet_part


def chart(belongs=None):
    """Returns a chart of a sheet of 100 x 100 mm. `belongs`: mask of the vertices in the chart."""
    part = sheet_part(4)
    return Chart(part, part.positions[:, :2] * 100, np.ones(25, bool) if belongs is None else belongs)


def test_points_are_converted_to_uv():
    assert chart().uv(np.array([[25.0, 75.0], [10.0, 10.0]])) == pytest.approx(np.array([[0.25, 0.25], [0.1, 0.9]]))


def test_points_outside_are_nan():
    assert np.isnan(chart().uv(np.array([[101.0, 50.0]]))).all()
    left = sheet_part(4).positions[:, 0] < 0.6
    assert np.isnan(chart(left).uv(np.array([[75.0, 50.0]]))).all()


def test_a_stroke_runs_through_its_points():
    (stroke,) = chart().stroke("brow", [(30, 50), (50, 60), (70, 50)], 2.0, 0.5, taper=0.3)
    assert {key: stroke[key] for key in ("group", "width", "depth", "taper")} == {
        "group": "brow",
        "width": 2.0,
        "depth": 0.5,
        "taper": 0.3,
    }
    assert len(stroke["points"]) == SAMPLES
    assert stroke["points"][0] == [0.3, 0.5]
    assert stroke["points"][-1] == [0.7, 0.5]


def test_a_stroke_ends_where_its_chart_does():
    (stroke,) = chart().stroke("brow", [(80, 50), (120, 50)], 2.0, 0.5)
    assert stroke["points"][0] == [0.8, 0.5]
    assert 0.97 < stroke["points"][-1][0] <= 1
    assert chart().stroke("brow", [(150, 50), (250, 50)], 2.0, 0.5) == []


def test_a_stroke_does_not_leap_over_a_seam():
    part = sheet_part(4)
    flat = part.positions[:, :2] * 100
    part.uv = np.where(part.positions[:, :1] > 0.5, part.uv * [1, 0.1], part.uv)
    seamed = Chart(part, flat, np.ones(25, bool))
    (stroke,) = seamed.stroke("brow", [(30, 20), (70, 20)], 2.0, 0.5)
    assert len(stroke["points"]) < SAMPLES
    assert np.linalg.norm(np.diff(stroke["points"], axis=0), axis=1).max() < LEAP


def test_documents_are_json_with_an_item_per_line():
    text = document([{"group": "a"}, {"group": "b"}], [{"name": "a"}], 1024)
    assert json.loads(text) == {
        "version": 1,
        "size": 1024,
        "strokes": [{"group": "a"}, {"group": "b"}],
        "areas": [{"name": "a"}],
    }
    assert '    {"group": "b"}\n' in text
