"""Creates the animation clips: the hand closes to a fist, and the head turns and nods.

Angles are in degrees. They were chosen by eye, so that the fingers do not intersect.
"""

import numpy as np
from scipy.spatial.transform import Rotation

# Rotations of each joint about its x (positive towards the palm), y (along the bone) and z axis.
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
# The angles of the joints sum to 60 degrees for a turn and to 26 degrees for a nod.
TURN = {"neck01": (0, 11, 0), "neck02": (0, 15, 0), "neck03": (0, 17, 0), "head": (0, 17, 0)}
NOD = {"neck01": (4, 0, 0), "neck02": (6, 0, 0), "neck03": (7, 0, 0), "head": (9, 0, 0)}
STEP = 0.1  # seconds between key frames


def hand_clip() -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Returns the clip `fist`. The thumb closes after the fingers."""
    return clip(FIST, 1.4, 0.6, lambda joint, t: 1.6 * t - 0.6 if joint.startswith("finger1-") else 1.25 * t)


def neck_clips() -> dict[str, tuple[np.ndarray, dict[str, np.ndarray]]]:
    """Returns two clips. In `turn`, the head turns left and back, then right and back. In `nod`, it nods once."""
    seconds, left = clip(TURN, 1.2, 0.4)
    right = clip({joint: (0, -angles[1], 0) for joint, angles in TURN.items()}, 1.2, 0.4)[1]
    both = {joint: np.concatenate([left[joint], right[joint][1:]]) for joint in TURN}
    return {"turn": (np.concatenate([seconds, seconds[-1] + seconds[1:]]), both), "nod": clip(NOD, 1.0, 0.4)}


def clip(
    pose: dict, closing: float, held: float, progress=lambda joint, t: t
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Animates from rest to a pose and back. Returns times (t,) in seconds, and rotations (t, 3, 3) by joint name.

    The motion to the pose takes `closing` seconds. The pose is held for `held` seconds. The motion back takes `closing`
    seconds.
    `progress(joint, t)` maps the progress `t` of the motion, 0..1, to the progress of a joint. The result is clamped to
    0..1 and eased at both ends.
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
    """Returns the rotation matrix (3, 3) for rotations about the fixed x axis first, then about z, then about y."""
    x, y, z = angles
    return Rotation.from_euler("YZX", [y, z, x], degrees=True).as_matrix()
