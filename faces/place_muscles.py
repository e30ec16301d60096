"""Writes human/muscles.json and human-2/muscles.json: virtual muscles, and expressions as contractions of muscles.

Origins and insertions follow the anatomy of facial muscles (Waters 1987; Gray's Anatomy). The table below lists them in
uv, and the script converts them to metres. Run it after building the faces:

    python faces/place_muscles.py
"""

import json
import struct
from pathlib import Path

import numpy as np

FACES = Path(__file__).parent
FORMATS = {5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

# Name, kind, origin in uv, insertion in uv, and options. `width`, `angle`, `strength`, `inner` and `outer` are those of
# a driver of type `muscle`, see docs/FURROW_wrinkle_maps.md. `depth` is the distance of the origin below the skin in
# metres (default 0.004), and negative if the origin is in front of the skin. The table lists the left muscle of each
# pair; `sides: False` marks muscles without a pair. The openings of the eyes and the mouth have no skin, so an origin
# in an opening is a list of skin points around it. The script uses the mean of these points.
MUSCLES = [
    (
        "frontalisInner",
        "sheet",
        (0.543, 0.300),
        (0.543, 0.445),
        {"width": 0.019, "strength": 0.15, "inner": 0.95, "outer": 1.28},
    ),
    (
        "frontalisOuter",
        "sheet",
        (0.612, 0.325),
        (0.612, 0.440),
        {"width": 0.021, "strength": 0.17, "inner": 0.95, "outer": 1.38},
    ),
    (
        "corrugator",
        "linear",
        (0.507, 0.480),
        (0.560, 0.440),
        {"angle": 0.62, "strength": 0.22, "inner": 0.85, "outer": 1.75},
    ),
    (
        "procerus",
        "sheet",
        (0.5, 0.545),
        (0.5, 0.450),
        {"width": 0.013, "strength": 0.13, "inner": 0.85, "outer": 1.45, "sides": False},
    ),
    (
        "orbicularisOculi",
        "sphincter",
        [(0.5917, 0.4812), (0.5987, 0.5415)],
        (0.6435, 0.5192),
        {"width": 0.0135, "strength": 0.24, "inner": 0.75, "outer": 1.55, "depth": 0.004},
    ),
    (
        "levatorPalpebrae",
        "sheet",
        (0.593, 0.452),
        (0.5935, 0.489),
        {"width": 0.0125, "strength": 0.16, "inner": 0.9, "outer": 1.25},
    ),
    (
        "levatorLabii",
        "linear",
        (0.578, 0.572),
        (0.533, 0.690),
        {"angle": 0.24, "strength": 0.17, "inner": 0.85, "outer": 1.06},
    ),
    (
        "nasalis",
        "linear",
        (0.520, 0.520),
        (0.553, 0.650),
        {"angle": 0.30, "strength": 0.17, "inner": 0.8, "outer": 1.12},
    ),
    (
        "zygomaticMinor",
        "linear",
        (0.650, 0.590),
        (0.566, 0.708),
        {"angle": 0.26, "strength": 0.14, "inner": 0.85, "outer": 1.16},
    ),
    (
        "zygomaticMajor",
        "linear",
        (0.672, 0.612),
        (0.581, 0.733),
        {"angle": 0.42, "strength": 0.21, "inner": 0.84, "outer": 1.2},
    ),
    (
        "depressorAnguliOris",
        "linear",
        (0.612, 0.815),
        (0.5825, 0.735),
        {"angle": 0.42, "strength": 0.28, "inner": 0.8, "outer": 1.42},
    ),
    (
        "depressorLabii",
        "linear",
        (0.548, 0.815),
        (0.528, 0.762),
        {"angle": 0.45, "strength": 0.24, "inner": 0.85, "outer": 1.12},
    ),
    (
        "mentalis",
        "sheet",
        (0.5, 0.755),
        (0.5, 0.797),
        {"width": 0.019, "strength": 0.16, "inner": 0.8, "outer": 1.6, "sides": False},
    ),
    (
        "orbicularisOris",
        "sphincter",
        [(0.5, 0.6904), (0.5, 0.7656)],
        (0.5829, 0.733),
        {"width": 0.0185, "strength": 0.30, "inner": 0.75, "outer": 1.7, "depth": -0.016, "sides": False},
    ),
    (
        "platysma",
        "sheet",
        (0.610, 0.905),
        (0.606, 0.800),
        {"width": 0.020, "strength": 0.10, "inner": 0.85, "outer": 1.35},
    ),
]

# The neutral face and Ekman's six basic expressions, as contractions of muscles, 0..1. Paired muscles contract on both
# sides.
EXPRESSIONS = {
    "neutral": {},
    "happiness": {"zygomaticMajor": 1, "zygomaticMinor": 0.5, "orbicularisOculi": 0.55},
    "surprise": {"frontalisInner": 1, "frontalisOuter": 1, "levatorPalpebrae": 1, "depressorLabii": 0.5},
    "anger": {
        "corrugator": 1,
        "procerus": 0.8,
        "orbicularisOculi": 0.3,
        "levatorPalpebrae": 0.3,
        "orbicularisOris": 0.35,
        "mentalis": 0.4,
        "depressorAnguliOris": 0.2,
    },
    "sadness": {
        "frontalisInner": 0.9,
        "corrugator": 0.6,
        "depressorAnguliOris": 1,
        "mentalis": 0.5,
        "orbicularisOculi": 0.15,
    },
    "fear": {
        "frontalisInner": 1,
        "frontalisOuter": 0.6,
        "corrugator": 0.6,
        "levatorPalpebrae": 1,
        "platysma": 1,
        "depressorLabii": 0.5,
    },
    "disgust": {
        "nasalis": 1,
        "levatorLabii": 1,
        "corrugator": 0.5,
        "procerus": 0.6,
        "orbicularisOculi": 0.4,
        "depressorAnguliOris": 0.3,
        "mentalis": 0.3,
    },
}


def read_skin(path):
    """Reads positions (n, 3), texture coordinates (n, 2) and normals (n, 3) of the first mesh of a .glb file."""
    file = path.read_bytes()
    length = struct.unpack("<I", file[12:16])[0]
    gltf, data = json.loads(file[20 : 20 + length]), file[28 + length :]

    def numbers(index):
        accessor = gltf["accessors"][index]
        view = gltf["bufferViews"][accessor["bufferView"]]
        width = WIDTHS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        kind = FORMATS[accessor["componentType"]]
        return np.frombuffer(data, kind, accessor["count"] * width, start).reshape(-1, width).astype(float)

    attributes = gltf["meshes"][0]["primitives"][0]["attributes"]
    return (numbers(attributes[name]) for name in ("POSITION", "TEXCOORD_0", "NORMAL"))


def position_of(skin, points, depth=0.0):
    """Converts a point in uv to a position, `depth` metres below the skin. A negative depth is in front of the skin.

    The position is interpolated from the nearest vertices. For a list of points, returns the mean of their positions.
    """
    positions, uvs, normals = skin
    means = []
    for point in points if isinstance(points, list) else [points]:
        distances = np.linalg.norm(uvs - point, axis=1)
        nearest = np.argsort(distances)[:4]
        weights = 1 / (distances[nearest] + 1e-4) ** 2
        means.append([np.average(values[nearest], axis=0, weights=weights) for values in (positions, normals)])
    position, normal = np.mean(means, axis=0)
    return position - depth * normal / np.linalg.norm(normal)


def muscles_of(skin):
    """Returns the muscles of a face as drivers. Each driver activates the wrinkle area with the muscle's name."""
    found = []
    for name, kind, origin, insertion, more in MUSCLES:
        more = dict(more)
        depth, sides = more.pop("depth", 0.004), more.pop("sides", True)
        left = [position_of(skin, origin, depth), position_of(skin, insertion)]
        for side, sign in (("Left", 1), ("Right", -1)) if sides else (("", 0),):
            ends = [[round(float(value), 5) + 0.0 for value in end * (sign, 1, 1)] for end in left]
            if kind == "sphincter" and not sides:
                ends[1][0] = round(float(left[1][0]), 5)
            found.append(
                {
                    "type": "muscle",
                    "name": name + side,
                    "area": name + side,
                    "kind": kind,
                    "origin": ends[0],
                    "insertion": ends[1],
                    **more,
                }
            )
    return found


def expressions_of(muscles):
    """Returns the expressions as drivers."""
    names = [muscle["name"] for muscle in muscles]
    for name, contractions in EXPRESSIONS.items():
        targets = [
            {"name": side_name, "weight": weight}
            for muscle, weight in contractions.items()
            for side_name in names
            if side_name in (muscle, muscle + "Left", muscle + "Right")
        ]
        yield {"type": "expression", "name": name, "targets": targets}


if __name__ == "__main__":
    for face in ("human", "human-2"):
        muscles = muscles_of(tuple(read_skin(FACES / f"{face}.glb")))
        lines = ",\n".join(json.dumps(driver) for driver in [*muscles, *expressions_of(muscles)])
        (FACES / face / "muscles.json").write_text(f"[\n{lines}\n]\n")
