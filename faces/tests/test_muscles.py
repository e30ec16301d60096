import json

import numpy as np
import pytest

from place_muscles import FACES, MUSCLES, expressions_of, muscles_of, position_of, read_skin
from tests.shapes import sheet_part


@pytest.fixture
def sheet():
    part = sheet_part(40)
    return part.positions, part.uv, part.normals


def test_positions_are_interpolated(sheet):
    assert position_of(sheet, (0.25, 0.25)) == pytest.approx([0.25, 0.75, 0], abs=1e-3)
    assert position_of(sheet, [(0.25, 0.5), (0.75, 0.5)]) == pytest.approx([0.5, 0.5, 0], abs=1e-3)


def test_depth_is_under_the_skin(sheet):
    assert position_of(sheet, (0.5, 0.5), 0.01)[2] == pytest.approx(-0.01)


def test_paired_muscles_mirror_each_other(sheet):
    muscles = {muscle["name"]: muscle for muscle in muscles_of(sheet)}
    left, right = muscles["corrugatorLeft"], muscles["corrugatorRight"]
    assert right["origin"] == [-left["origin"][0], *left["origin"][1:]]
    assert "procerus" in muscles
    assert muscles["procerus"]["origin"][0] == 0


def test_expressions_name_muscles_that_exist(sheet):
    muscles = muscles_of(sheet)
    assert len(muscles) == sum(2 if more.get("sides", True) else 1 for *_, more in MUSCLES)
    names = {muscle["name"] for muscle in muscles}
    for expression in expressions_of(muscles):
        assert {target["name"] for target in expression["targets"]} <= names


@pytest.mark.parametrize("face", ["human", "human-2"])
def test_the_shipped_muscles_match_the_faces(face):
    muscles = muscles_of(tuple(read_skin(FACES / f"{face}.glb")))
    shipped = json.loads((FACES / face / "muscles.json").read_text())
    assert shipped == [*muscles, *expressions_of(muscles)]


def test_skins_are_read_completely():
    positions, uv, normals = read_skin(FACES / "human.glb")
    assert positions.shape == normals.shape == (12885, 3)
    assert uv.shape == (12885, 2)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1, abs=1e-4)
