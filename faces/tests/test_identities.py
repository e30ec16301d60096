import numpy as np
import pytest

from builder.identities.amounts import identity
from builder.identities.carry import carry, vary
from builder.identities.decimate import decimate
from builder.identities.heads import Figure
from builder.identities.stylise import Places, Style, stylise
from builder.part import Part
from builder.source import Mesh
from sample_heads import seeds
from tests.shapes import grid

PLACES = Places(
    eyes=np.array([[0.031, 0, 0], [-0.031, 0, 0]]),
    nose=np.array([0, -0.035, 0.02]),
    mouth=np.array([0, -0.07, 0.02]),
    chin=-0.11,
    neck=np.array([0, 0, -0.06]),
)


@pytest.fixture
def sheet():
    """Returns a sheet of 20 x 20 cells with corners (0, 0) and (0.1, 0.1), metres."""
    positions, quads = grid(20)
    return positions * 0.1, quads


def test_a_seed_gives_one_person():
    assert identity(3) == identity(3)
    assert identity(3) != identity(4)
    for amounts in map(identity, range(1, 30)):
        people = sum(v for k, v in amounts.items() if k.startswith("macrodetails/") and "universal" not in k)
        builds = sum(v for k, v in amounts.items() if "universal" in k)
        assert people == pytest.approx(1, abs=0.01)
        assert builds == pytest.approx(1, abs=0.01)
        assert 0 < min(amounts.values()) <= max(amounts.values()) <= 1


def test_a_seed_gives_one_head(sheet):
    positions, quads = sheet
    positions = positions + np.array([-0.05, 0.62, 0])

    class Targets:
        def shape(self, name):
            return positions * 0.01 * len(name)

        face_unit = shape

    mesh = Mesh(positions, positions[:, :2], quads, quads, np.full(len(quads), "body"))
    (first, moves), (again, moves_again), (other, _) = (Figure(Targets(), mesh).person(seed) for seed in (3, 3, 4))
    assert (first == again).all()
    assert all((moves[name] == moves_again[name]).all() for name in moves)
    assert np.abs(first - other).max() > 1e-4


def test_spans_of_seeds_are_read():
    assert seeds("101-103") == [101, 102, 103]
    assert seeds("7") == [7]


def test_expressions_are_deformed_with_the_person(sheet):
    positions, _ = sheet
    wider = positions * [1.4, 1, 1]
    units = {"jawOpen": np.tile([0.01, 0.01, 0], (len(positions), 1)) * (positions[:, :1] > 0.03)}
    carried = carry(units, positions, wider, np.arange(len(positions)))["jawOpen"]
    moving = positions[:, 0] > 0.03
    assert (carried[~moving] == 0).all()
    assert (carried[moving, 0] > 0.0115).all()
    assert carried[moving, 1] == pytest.approx(0.01, abs=5e-4)


def test_lids_meet_on_a_person_with_larger_eyes(sheet):
    positions, _ = sheet
    upper, lower = np.flatnonzero(positions[:, 1] > 0.0701), np.flatnonzero(positions[:, 1] < 0.0299)
    lids = np.concatenate([upper, lower])
    # The edge of the upper lid at y = 0.075 moves to the edge of the lower lid at y = 0.025.
    edge = upper[np.isclose(positions[upper, 1], 0.075)]
    below = lower[np.isclose(positions[lower, 1], 0.025)]
    unit = np.zeros_like(positions)
    unit[edge, 1] = -0.05
    person = positions * [1, 1.5, 1]
    carried = carry({"eyeBlinkLeft": unit}, positions, person, np.sort(lids))["eyeBlinkLeft"]
    gap = np.abs((person + carried)[edge, 1] - person[below, 1])
    assert gap.max() < 1e-3
    assert np.abs((person + unit)[edge, 1] - person[below, 1]).min() > 0.02


def test_artists_differ_in_strength_but_lids_still_meet(sheet):
    positions, _ = sheet
    sides = [f"{stem}{side}" for stem in ("mouthSmile", "cheekSquint", "mouthDimple") for side in ("Left", "Right")]
    units = {name: np.full_like(positions, 0.01) for name in ["eyeBlinkLeft", "noseSneerLeft", *sides]}
    units["mouthUpperUpLeft"] = units["eyeSquintLeft"] = units["eyeSquintRight"] = np.full_like(positions, 0.01)
    one, same, other = (vary(units, positions, np.random.default_rng(seed)) for seed in (1, 1, 2))
    assert (one["eyeBlinkLeft"] == units["eyeBlinkLeft"]).all()
    assert (one["mouthSmileLeft"] == same["mouthSmileLeft"]).all()
    assert np.abs(one["mouthSmileLeft"] - other["mouthSmileLeft"]).max() > 1e-4
    assert one["mouthSmileLeft"].std() > 1e-4


def test_a_cartoon_has_larger_eyes_and_space_does_not_fold():
    style = Style(eyes=0.52, apart=0.095, wide=1.1, nose=0.65, mouth=0.4, skull=0.3, jaw=0.15, neck=0.5)
    lens = np.array([[0.031 + x, y, 0] for x in (-0.01, 0.01) for y in (-0.004, 0.004)])
    grown = np.ptp(stylise(lens, PLACES, style), axis=0) / [0.02, 0.008, 1]
    assert (grown[:2] > 1.45).all()
    axis = np.linspace(-0.12, 0.12, 33)
    points = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    step = 1e-5
    here = stylise(points, PLACES, style)
    columns = [(stylise(points + step * d, PLACES, style) - here) / step for d in np.eye(3)]
    assert np.linalg.det(np.stack(columns, axis=-1)).min() > 0


def test_decimation_keeps_borders_attributes_and_the_layout(sheet):
    positions, quads = sheet
    bump = positions + np.array([0, 0, 0.02]) * np.exp(
        -((positions - [0.05, 0.05, 0]) ** 2).sum(axis=1, keepdims=True) / 4e-4
    )
    uv = positions[:, :2] * 10
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    shift = bump * [0, 0, 1]
    part = Part("skin", "skin", bump, np.zeros_like(bump), uv, triangles, targets={"jawOpen": (shift, shift)})
    less = decimate(part, 150)
    assert len(less.positions) == 150
    rows = {tuple(p): i for i, p in enumerate(bump)}
    kept = [rows[tuple(p)] for p in less.positions]
    assert (less.uv == uv[kept]).all()
    assert (less.targets["jawOpen"][0] == shift[kept]).all()
    border = np.flatnonzero(((uv == 0) | (uv == 1)).any(axis=1))
    assert set(border) <= set(kept)
    a, b = (less.uv[less.triangles[:, k]] - less.uv[less.triangles[:, 0]] for k in (1, 2))
    areas = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    assert (areas > 0).all()
    assert areas.sum() / 2 == pytest.approx(1)
    # Vertices are removed from flat skin first, so the bump keeps its height.
    assert less.positions[:, 2].max() > 0.0195
