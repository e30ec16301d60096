"""Builds the parts of a random head, in a realistic or a cartoon style."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..part import Part
from ..person.eyes import ball_of, eye_part
from ..person.head import Head, coarse_skin, regions, skin_part, subdivided
from ..person.mouth import mouth_part, socket_part, teeth_part, tongue_part
from ..source import ARKIT, Mesh, Wheel
from ..subdivide import vertex_normals
from .amounts import identity
from .carry import carry, vary
from .decimate import decimate
from .stylise import places_of, style_of, stylise

IRIS, PUPIL, WHITE = (0.16, 0.12, 0.09), (0.01, 0.01, 0.01), (0.72, 0.69, 0.66)  # linear
HELPERS = ("helper-l-eye", "helper-r-eye", "helper-lower-teeth", "helper-upper-teeth", "helper-tongue")

# Number of vertices of each part of a cartoon head.
COUNTS = {"skin": 2200, "eye-left": 400, "eye-right": 400, "tongue": 150, "mouth": 400, "sockets": 300}

MATERIALS = [
    {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*colour, 1], "metallicFactor": 0, "roughnessFactor": r}}
    for name, colour, r in [
        ("skin", (0.55, 0.36, 0.27), 0.55),
        ("eye", (1, 1, 1), 0.25),
        ("teeth", (1, 1, 1), 0.3),
        ("tongue", (1, 1, 1), 0.45),
        ("mouth", (1, 1, 1), 0.8),
    ]
]


class Figure:
    """The base figure of MakeHuman and its expressions, which all heads share."""

    def __init__(self, wheel: Wheel, mesh: Mesh):
        self.wheel, self.mesh = wheel, mesh
        self.units = {name: wheel.face_unit(name) for name in ARKIT}
        region, _ = regions(mesh)
        helpers = np.isin(mesh.groups, HELPERS)
        self.used = np.unique(mesh.quads[(region != "") | helpers])

    def person(self, seed: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Returns a random person: the vertices at rest, (n, 3), and the displacements of the expressions."""
        random = np.random.default_rng([seed, 2])
        shapes = identity(seed)
        base = self.mesh.positions + sum(amount * self.wheel.shape(name) for name, amount in shapes.items())
        carried = carry(self.units, self.mesh.positions, base, self.used)
        varied = vary(carried, base, random)
        # Opens the eyes, which are half closed in the base figure.
        wide = random.uniform(0.15, 0.45)
        base = base + random.uniform(0, 0.08) * carried["mouthClose"]
        for side in ("Left", "Right"):
            rest = wide * carried["eyeWide" + side]
            base = base + rest + random.uniform(0, 0.12) * carried["mouthSmile" + side]
            varied["eyeBlink" + side] = varied["eyeBlink" + side] - rest
        return base, varied


def realistic(figure: Figure, seed: int) -> list[Part]:
    head = subdivided(figure.mesh, *figure.person(seed))
    skin, _ = skin_part(head)
    return [skin, *inner_parts(head, figure.mesh)]


def stylised(figure: Figure, seed: int) -> list[Part]:
    """Builds the same person as `realistic` does, but as a cartoon with few vertices and without teeth."""
    style = style_of(seed)
    base, units = figure.person(seed)
    for side in ("Left", "Right"):
        wider = style.wide * units["eyeWide" + side]
        base, units["eyeBlink" + side] = base + wider, units["eyeBlink" + side] - wider
    head = subdivided(figure.mesh, base, units)
    skin = coarse_skin(head)
    places = places_of(figure.mesh, base, skin.positions)
    parts = [part for part in inner_parts(head, figure.mesh, 1 + style.eyes / 2) if part.material != "teeth"]
    return [
        decimate(_warped(part, lambda points: stylise(points, places, style)), COUNTS[part.name])
        for part in [skin, *parts]
    ]


def _warped(part: Part, warp: Callable[[np.ndarray], np.ndarray]) -> Part:
    """Applies `warp`, a function of positions, to the vertices of a part and to its targets."""
    # A UV seam splits a vertex into several vertices at one position. They get the same normal.
    _, first, index = np.unique(part.positions, axis=0, return_index=True, return_inverse=True)
    index = index.ravel()
    welded = index[part.triangles]
    quads = np.c_[welded, welded[:, 2]]

    def normals(points):
        return vertex_normals(points[first], quads)[index]

    still = warp(part.positions)
    upright = normals(still)
    targets = {}
    for name, (shift, turn) in part.targets.items():
        moved = warp(part.positions + shift)
        targets[name] = (moved - still, None if turn is None else normals(moved) - upright)
    return replace(part, positions=still, normals=upright, targets=targets)


def inner_parts(head: Head, mesh: Mesh, iris=1.0) -> list[Part]:
    """Builds all parts except the skin. `iris`: scale factor of the irises."""
    return [
        *[_eye(head, mesh, side, iris) for side in ("left", "right")],
        teeth_part(head, mesh, "upper"),
        teeth_part(head, mesh, "lower"),
        tongue_part(head, mesh),
        mouth_part(head),
        socket_part(head),
    ]


def _eye(head: Head, mesh: Mesh, side: str, iris: float) -> Part:
    """Builds an eyeball. Its vertex colours show the iris and the pupil."""
    part = eye_part(head, mesh, side)
    ball = ball_of(head, mesh, side)
    direction = part.positions - ball.centre
    tilt = np.arccos(np.clip(direction[:, 2] / np.linalg.norm(direction, axis=1), -1, 1)) / ball.limbus / iris
    colours = np.where((tilt < 0.4)[:, None], PUPIL, np.where((tilt < 1)[:, None], IRIS, WHITE))
    return replace(part, colours=np.c_[colours, np.ones(len(tilt))])
