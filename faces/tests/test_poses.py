import numpy as np
import pytest

from builder.joints.poses import FIST, STEP, clip, hand_clip, neck_clips, turn


def test_a_turn_about_x_bends_y_towards_z():
    assert turn((90, 0, 0)) @ [0, 1, 0] == pytest.approx([0, 0, 1])


def test_a_turn_is_about_x_then_z_then_y():
    about = {axis: turn(np.eye(3)[k] * angle) for axis, k, angle in (("x", 0, 20), ("y", 1, 30), ("z", 2, 40))}
    assert turn((20, 30, 40)) == pytest.approx(about["y"] @ about["z"] @ about["x"])


def test_a_clip_goes_to_its_pose_and_back():
    seconds, turns = clip({"joint": (90, 0, 0)}, 1.0, 0.4)
    assert np.diff(seconds) == pytest.approx(STEP)
    assert seconds[-1] == pytest.approx(2.4)
    assert turns["joint"][0] == pytest.approx(np.eye(3))
    assert turns["joint"][-1] == pytest.approx(np.eye(3))
    for frame in range(10, 15):
        assert turns["joint"][frame] == pytest.approx(turn((90, 0, 0)))


def test_every_joint_of_the_fist_moves():
    seconds, turns = hand_clip()
    assert turns.keys() == FIST.keys()
    for matrices in turns.values():
        assert matrices.shape == (len(seconds), 3, 3)
        assert not np.allclose(matrices[len(seconds) // 2], np.eye(3))


def test_the_head_turns_left_then_right():
    seconds, turns = neck_clips()["turn"]
    forwards = turns["head"] @ [0.0, 0.0, 1.0]
    middle = len(seconds) // 2
    assert forwards[middle] == pytest.approx([0, 0, 1])
    assert forwards[middle // 2, 0] == pytest.approx(-forwards[-1 - middle // 2, 0])
    assert forwards[middle // 2, 0] > 0.2
