import numpy as np
import pytest

from builder.tangents import tangents
from tests.shapes import sheet_part


def test_tangents_follow_u():
    part = sheet_part()
    assert tangents(part) == pytest.approx(np.tile([1, 0, 0, 1], (9, 1)))


def test_tangents_follow_a_turned_layout():
    part = sheet_part()
    u, v = part.uv.T
    part.uv = np.stack([v, 1 - u], axis=1)  # rotated by 90 degrees, so that u increases along -y
    assert tangents(part) == pytest.approx(np.tile([0, -1, 0, 1], (9, 1)))


def test_tangents_are_unit_and_perpendicular_to_normals():
    part = sheet_part(4)
    rng = np.random.default_rng(0)
    part.normals = part.normals + rng.uniform(-0.3, 0.3, part.normals.shape)
    part.normals /= np.linalg.norm(part.normals, axis=1, keepdims=True)
    found = tangents(part)[:, :3]
    assert np.linalg.norm(found, axis=1) == pytest.approx(1)
    assert (found * part.normals).sum(axis=1) == pytest.approx(0)


def test_a_mirrored_layout_is_refused():
    part = sheet_part()
    part.uv[:, 0] = 1 - part.uv[:, 0]
    with pytest.raises(ValueError, match="mirrored triangles in sheet, got 8"):
        tangents(part)
