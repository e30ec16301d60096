"""Creates the animation clips of the figure: it walks, sits, reaches, makes fists, turns and bends.

Angles are in degrees, about the x, y and z axes of each joint; see `turn` in `builder/joints/poses.py`. Positive
rotations about x bend limbs, and move legs and the trunk forwards.
"""

import numpy as np

from ..joints.poses import STEP, clip, hand_clip, turn
from ..rig import Rig
from .skeleton import SIDES, Limb

# Angles of a stride at eight even times, from the moment at which the heel strikes.
STRIDE = {
    "upperleg01": [26, 20, 6, -8, -16, -4, 20, 30],
    "lowerleg01": [4, 18, 12, 8, 34, 62, 48, 12],
    "foot": [6, -6, 2, 10, -18, -4, 2, 6],
    "upperarm01": [-20, -14, -2, 10, 18, 12, 0, -14],
    "lowerarm01": [4, 5, 10, 17, 22, 17, 10, 5],
}
STRIDE_SECONDS = 1.2
SIT = {"upperleg01": (84, 0, 0), "lowerleg01": (92, 0, 0), "spine04": (8, 0, 0), "upperarm01": (16, 0, 0)}
SIT |= {"lowerarm01": (72, 0, 0)}
REACH = {"upperarm01": (58, 0, 0), "lowerarm01": (98, 0, 0), "shoulder01": (4, 0, 0)}
TURN = {"spine04": (0, 9, 0), "spine03": (0, 11, 0), "spine02": (0, 11, 0), "neck01": (0, 8, 0), "neck02": (0, 10, 0)}
TURN |= {"neck03": (0, 12, 0), "head": (0, 10, 0)}
SPINE = ("spine05", "spine04", "spine03", "spine02")
FORWARD = dict.fromkeys(SPINE, (11, 0, 0))
SIDEWAYS = dict.fromkeys(SPINE, (0, 0, 7))
# The arms of the bind pose point to the sides. At rest they hang.
HANG = {"upperarm01": 27.0}  # degrees towards the body
ELBOW = 30.0  # degrees by which the elbows of the bind pose are bent too much
HIP_SPREAD = 7.0  # degrees by which the legs of the bind pose are apart


def figure_clips(rig: Rig) -> dict[str, tuple]:
    """Returns, by name, the times in seconds, rotation matrices by joint, and positions of the root."""
    walk = _walk(rig)
    sit = _whole(rig, *clip(both(SIT), 1.2, 0.8), drop=_seat(rig))
    reach = _whole(rig, *clip(both(REACH), 1.0, 0.8))
    seconds, fists = hand_clip()
    mirrored = {joint.replace(".L", ".R"): _mirrored(turns) for joint, turns in fists.items()}
    raised = clip({f"lowerarm01.{side}": (84, 0, 0) for side in SIDES}, 1.4, 0.6)[1]
    fist = _whole(rig, seconds, {**fists, **mirrored, **raised})
    turned = _both(rig, TURN, {joint: (0, -angles[1], 0) for joint, angles in TURN.items()})
    bent = _both(rig, FORWARD, SIDEWAYS)
    return {"walk": walk, "sit": sit, "reach": reach, "fist": fist, "turn": turned, "bend": bent}


def _both(rig: Rig, first: dict, second: dict) -> tuple:
    """Returns a clip that goes to one pose and back, then to another pose of the same joints and back."""
    times, there = clip(first, 1.2, 0.6)
    back = clip(second, 1.2, 0.6)[1]
    turns = {joint: np.concatenate([there[joint], back[joint][1:]]) for joint in first}
    return _whole(rig, np.concatenate([times, times[-1] + times[1:]]), turns)


def both(pose: dict) -> dict:
    """Returns a pose with the joints of both sides."""
    paired = {f"{name}.{side}": angles for name, angles in pose.items() for side in SIDES if name in _PAIRED}
    return paired | {name: angles for name, angles in pose.items() if name not in _PAIRED}


_PAIRED = ("upperleg01", "lowerleg01", "foot", "upperarm01", "lowerarm01", "shoulder01")


def _walk(rig: Rig) -> tuple:
    seconds = np.arange(round(STRIDE_SECONDS / STEP) + 1) * STEP
    phase = seconds / STRIDE_SECONDS
    turns = {}
    for side, shift in (("L", 0.0), ("R", 0.5)):
        for name, angles in STRIDE.items():
            turns[f"{name}.{side}"] = np.array([turn((a, 0, 0)) for a in _loop(angles, phase + shift)])
    swing = 5 * np.cos(2 * np.pi * phase)
    turns["spine03"] = np.array([turn((2, -a, 0)) for a in swing])
    turns["spine02"] = np.array([turn((2, -a, 0)) for a in swing])
    turns["neck02"] = np.array([turn((-2, 1.4 * a, 0)) for a in swing])
    bob = np.zeros((len(seconds), 3))
    bob[:, 1] = -0.016 - 0.016 * np.cos(4 * np.pi * phase)
    return _whole(rig, seconds, turns, bob)


def _loop(values: list, phase: np.ndarray) -> np.ndarray:
    """Interpolates a closed cycle smoothly: the Fourier series through the values."""
    spectrum = np.fft.rfft(values) / len(values)
    out = np.full(len(phase), spectrum[0].real)
    for k in range(1, len(spectrum)):
        weight = 1 if 2 * k == len(values) else 2
        out += weight * (spectrum[k] * np.exp(2j * np.pi * k * phase)).real
    return out


def _whole(rig: Rig, seconds: np.ndarray, turns: dict, bob: np.ndarray | None = None, drop=None) -> tuple:
    """Adds to a clip that the arms hang and that the legs stand upright. The other joints of a clip start at rest."""
    count = len(seconds)
    turns = dict(turns)
    for name, angles in _standing(rig).items():
        turns[name] = angles @ turns.get(name, np.broadcast_to(np.eye(3), (count, 3, 3)))
    shifts = np.zeros((count, 3)) if bob is None else bob
    if drop is not None:
        shifts = np.array([drop(turns, frame) for frame in range(count)])
    return seconds, turns, shifts


def _standing(rig: Rig) -> dict[str, np.ndarray]:
    """Returns rotations, in the joints' frames, that lower and straighten the arms, and bring the legs together."""
    out = {}
    for side, sign in zip(SIDES, (1, -1), strict=True):
        for name, degrees in (("upperarm01", -sign * HANG["upperarm01"]), ("upperleg01", -sign * HIP_SPREAD)):
            frame = rig.frames[rig.names.index(f"{name}.{side}")]
            out[f"{name}.{side}"] = frame.T @ _about_z(degrees) @ frame
        out[f"lowerarm01.{side}"] = turn((-ELBOW, 0, 0))
    return out


def _about_z(degrees: float) -> np.ndarray:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def _seat(rig: Rig):
    """Returns a function that keeps the feet on the ground and in place."""
    leg = Limb(rig, "leg", "L")
    thigh, shin = leg.upper * leg.length[0], leg.lower * leg.length[1]

    def shift(turns: dict, frame: int) -> np.ndarray:
        hip, knee = (rig.names.index(f"{name}.L") for name in ("upperleg01", "lowerleg01"))
        at_hip = rig.frames[hip] @ turns["upperleg01.L"][frame] @ rig.frames[hip].T
        at_knee = at_hip @ rig.frames[knee] @ turns["lowerleg01.L"][frame] @ rig.frames[knee].T
        standing = rig.frames[hip] @ turns["upperleg01.L"][0] @ rig.frames[hip].T
        moved = standing @ (thigh + shin) - (at_hip @ thigh + at_knee @ shin)
        return np.array([0, moved[1], moved[2]])

    return shift


def _mirrored(turns: np.ndarray) -> np.ndarray:
    """Mirrors rotations in the frame of a joint, whose x axis changes its sign in the mirror."""
    flip = np.diag([1.0, -1.0, -1.0])
    return flip @ turns @ flip
