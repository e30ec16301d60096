"""Poses and clips: the fist of a hand, the turn and the nod of a head.

Angles are in degrees, chosen by eye to keep the fingers from intersecting.
"""

import numpy as np
from scipy.spatial.transform import Rotation

# Rotations by joint about x (positive towards the palm), y (along the bone) and z.
FIST = {
    "finger2-1.L": (76, 17, -5),
    "finger2-2.L": (92, 0, 0),
    "finger2-3.L": (52, 0, 0),
    "finger3-1.L": (80, 6, -2),
    "finger3-2.L": (96, 0, 0),
    "finger3-3.L": (56, 0, 0),
    "finger4-1.L": (82, -4, 3),
    "finger4-2.L": (96, 0, 0),
    "finger4-3.L": (56, 0, 0),
    "finger5-1.L": (84, -15, 8),
    "finger5-2.L": (92, 0, 0),
    "finger5-3.L": (56, 0, 0),
    "finger1-1.L": (30, -20, 4),
    "finger1-2.L": (38, 0, 0),
    "finger1-3.L": (58, 0, 0),
}
# Total angles are 60 degrees for a turn and 26 for a nod, shared by the neck's joints.
TURN = {"neck01": (0, 11, 0), "neck02": (0, 15, 0), "neck03": (0, 17, 0), "head": (0, 17, 0)}
NOD = {"neck01": (4, 0, 0), "neck02": (6, 0, 0), "neck03": (7, 0, 0), "head": (9, 0, 0)}
STEP = 0.1  # seconds between key frames


def hand_clip() -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Returns the fist's clip. The thumb closes after the fingers."""
    return clip(FIST, 1.4, 0.6, lambda joint, t: 1.6 * t - 0.6 if joint.startswith("finger1-") else 1.25 * t)


def neck_clips() -> dict[str, tuple[np.ndarray, dict[str, np.ndarray]]]:
    """Returns the clips `turn` (left and back, right and back) and `nod` (down and back)."""
    seconds, left = clip(TURN, 1.2, 0.4)
    right = clip({joint: (0, -angles[1], 0) for joint, angles in TURN.items()}, 1.2, 0.4)[1]
    both = {joint: np.concatenate([left[joint], right[joint][1:]]) for joint in TURN}
    return {"turn": (np.concatenate([seconds, seconds[-1] + seconds[1:]]), both), "nod": clip(NOD, 1.0, 0.4)}


def clip(
    pose: dict, closing: float, held: float, progress=lambda joint, t: t
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Animates from rest to a pose and back. Returns times (t,) in seconds, and rotations (t, 3, 3) by joint.

    `progress(joint, t)` maps the progress t of the clip to the progress of a joint, both 0..1. The motion is eased at
    both ends.
    """
    seconds = np.arange(round((2 * closing + held) / STEP) + 1) * STEP
    way = np.clip(np.minimum(seconds, 2 * closing + held - seconds) / closing, 0, 1)
    turns = {}
    for joint, angles in pose.items():
        t = np.clip(progress(joint, way), 0, 1)
        t = t * t * (3 - 2 * t)
        turns[joint] = np.array([turn(np.array(angles) * s) for s in t])
    return seconds, turns


def turn(angles) -> np.ndarray:
    """Returns the (3, 3) rotation in the joint's frame: about x, then z, then y."""
    x, y, z = angles
    return Rotation.from_euler("YZX", [y, z, x], degrees=True).as_matrix()
