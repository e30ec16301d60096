import numpy as np
import pytest

from builder.figure.clips import STRIDE, _loop, _mirrored, both
from builder.figure.figure import halved, two_hands, two_hands_normal
from builder.figure.unwrap import Chart, unwrap
from builder.joints.poses import turn


def test_a_stride_passes_through_its_angles_and_is_a_loop():
    values = STRIDE["lowerleg01"]
    phase = np.arange(9) / 8
    assert _loop(values, phase) == pytest.approx([*values, values[0]])


def test_a_pose_of_limbs_has_both_sides():
    assert both({"lowerleg01": (9, 0, 0), "spine03": (1, 0, 0)}) == {
        "lowerleg01.L": (9, 0, 0),
        "lowerleg01.R": (9, 0, 0),
        "spine03": (1, 0, 0),
    }


def test_a_mirrored_bend_stays_a_bend_and_a_mirrored_twist_changes_its_sign():
    assert _mirrored(turn((30, 0, 0))[None])[0] == pytest.approx(turn((30, 0, 0)))
    assert _mirrored(turn((0, 20, 0))[None])[0] == pytest.approx(turn((0, -20, 0)))


def test_the_right_hand_is_the_mirror_image_of_the_left_one():
    image = np.random.default_rng(1).random((4, 8, 3))
    both_hands = two_hands(image)
    assert both_hands.shape == (4, 8, 3)
    assert both_hands[:, 4:] == pytest.approx(both_hands[:, 3::-1])
    normals = two_hands_normal(image)
    assert normals[:, 4:, 0] == pytest.approx(1 - normals[:, 3::-1, 0])
    assert normals[:, :4] == pytest.approx(both_hands[:, :4])


def test_a_halved_map_has_the_same_mean():
    image = np.random.default_rng(2).random((6, 4, 3))
    assert halved(image).shape == (3, 2, 3)
    assert halved(image).mean(axis=(0, 1)) == pytest.approx(image.mean(axis=(0, 1)))


def _tube(x: float, part: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns points, quads and the weight of a limb, for a tube with 12 x 3 points around a vertical axis."""
    angle = np.arange(12) / 12 * 2 * np.pi
    rings = [np.stack([x + np.sin(angle), np.full(12, float(k)), np.cos(angle)], 1) for k in range(3)]
    quads = [
        [12 * k + i, 12 * k + (i + 1) % 12, 12 * k + 12 + (i + 1) % 12, 12 * k + 12 + i]
        for k in (0, 1)
        for i in range(12)
    ]
    return np.concatenate(rings), np.array(quads), np.full(36, float(part))


def test_unwrapped_tubes_cover_separate_parts_of_the_unit_square():
    tubes = [_tube(x, part) for x, part in ((0, 0), (5, 1), (-5, 1))]
    positions = np.concatenate([points for points, _, _ in tubes])
    quads = np.concatenate([own + 36 * k for k, (_, own, _) in enumerate(tubes)])
    limb = np.concatenate([weights for _, _, weights in tubes])

    def chart(x, sign):
        def place(points):
            return np.arctan2(points[:, 0] - x, points[:, 2]), points[:, 1]

        return Chart("limb", place, lambda weights, points: np.sign(np.round(points[:, 0] / 5)) == sign, 1.0)

    uv, corner, vertex = unwrap(positions, quads, [chart(0, 0), chart(5, 1), chart(-5, -1)], {"limb": limb})
    assert uv.min() > 0
    assert uv.max() < 1
    boxes = [
        (uv[corner[24 * k : 24 * k + 24]].min(axis=(0, 1)), uv[corner[24 * k : 24 * k + 24]].max(axis=(0, 1)))
        for k in range(3)
    ]
    for a in range(3):
        for b in range(a):
            assert (boxes[a][0] > boxes[b][1]).any() or (boxes[b][0] > boxes[a][1]).any()
    # The vertices at each seam have two texture coordinates.
    assert len(uv) == len(positions) + 3 * 3
    assert (positions[vertex[corner]] == positions[quads]).all()
