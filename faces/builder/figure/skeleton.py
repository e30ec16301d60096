"""Reads the figure's joints, and measures positions around and along its limbs."""

import numpy as np

from ..joints.hand import FINGERS, Inwards
from ..rig import Rig, read_rig, unit
from ..source import Mesh, Wheel

SPINE = ["root", "spine05", "spine04", "spine03", "spine02", "spine01", "neck01", "neck02", "neck03", "head"]
ARM = ["clavicle", "shoulder01", "upperarm01", "upperarm02", "lowerarm01", "lowerarm02", "wrist"]
HAND = [*[f"metacarpal{k}" for k in range(1, 5)], *[f"finger{f}-{k}" for f in FINGERS for k in (1, 2, 3)]]
LEG = ["pelvis", "upperleg01", "upperleg02", "lowerleg01", "lowerleg02", "foot"]
SIDES = ("L", "R")
JOINTS = [*SPINE, *[f"{name}.{side}" for side in SIDES for name in (*ARM, *HAND, *LEG)]]
# Joints at the ends and at the hinge of each limb.
LIMBS = {
    "arm": ("upperarm01", "lowerarm01", "wrist"),
    "leg": ("upperleg01", "lowerleg01", "foot"),
}
BEND = 0.08  # distance from a hinge over which both bones of a limb determine positions, metres


def read_skeleton(wheel: Wheel, mesh: Mesh, base: np.ndarray) -> Rig:
    return read_rig(wheel, mesh, base, JOINTS, _Inwards(wheel, mesh, base))


class Limb:
    """Measures positions around and along an arm or a leg."""

    def __init__(self, rig: Rig, kind: str, side: str):
        start, self.hinge, end = (rig.at(f"{name}.{side}") for name in LIMBS[kind])
        self.upper, self.lower = unit(self.hinge - start), unit(end - self.hinge)
        self.length = np.linalg.norm(self.hinge - start), np.linalg.norm(end - self.hinge)
        # Direction of angle 0: out of the bend of an arm, and to the front of a leg.
        front = -(self.lower - self.upper) if kind == "arm" else np.array([0.0, 0.0, 1.0])
        self._fronts = [unit(front - axis * (front @ axis)) for axis in (self.upper, self.lower)]

    def measure(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Returns the angle in radians, the distance from the hinge along the limb, and the vector from the axis."""
        offset = points - self.hinge
        t = np.clip(offset @ unit(self.upper + self.lower) / BEND + 0.5, 0, 1)
        t = (t * t * (3 - 2 * t))[:, None]
        along = (offset @ np.stack([self.upper, self.lower], axis=1) * np.hstack([1 - t, t])).sum(axis=1)
        axis = _units(self.upper * (1 - t) + self.lower * t)
        away = offset - axis * (offset * axis).sum(axis=1, keepdims=True)
        front = _units(self._fronts[0] * (1 - t) + self._fronts[1] * t)
        side = np.cross(axis, front)
        return np.arctan2((away * side).sum(axis=1), (away * front).sum(axis=1)), along, away


class _Inwards:
    """Maps the name of a joint to its bend direction: the spine and the hips bend forwards, and knees backwards."""

    def __init__(self, wheel: Wheel, mesh: Mesh, base: np.ndarray):
        still = read_rig(wheel, mesh, base, JOINTS, lambda name: np.array([0.1, 0.2, 1.0]))
        self._elbow = unit(still.at("wrist.L") - still.at("lowerarm01.L")) - unit(
            still.at("lowerarm01.L") - still.at("upperarm01.L")
        )
        self._hand = Inwards(wheel, mesh, base)

    def __call__(self, name: str) -> np.ndarray:
        bone = name.split(".")[0]
        if bone.startswith("lowerleg"):
            inwards = np.array([0.0, 0.0, -1.0])
        elif bone in ("foot", "clavicle", "shoulder01"):
            inwards = np.array([0.0, 1.0, 0.0])
        elif bone in ("upperarm01", "upperarm02", "lowerarm01", "lowerarm02"):
            inwards = self._elbow
        elif bone == "wrist" or bone in HAND:
            inwards = self._hand(f"{bone}.L")
        else:
            inwards = np.array([0.0, 0.0, 1.0])
        return inwards * [-1, 1, 1] if name.endswith(".R") else inwards


def _units(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-12)
