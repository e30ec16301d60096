"""Assembles the clothed figure: the head and the hands of the other models, with clothes and one skeleton."""

import numpy as np

from ..joints.hand import Hand
from ..joints.neck import Neck
from ..part import Part
from ..rig import Rig
from ..source import Mesh
from .clothes import Body, shirt_of, shoes_of, trousers_of


def clothes_of(rig: Rig, mesh: Mesh, base: np.ndarray) -> list[Part]:
    body = Body(rig, mesh, base)
    return [shirt_of(body), trousers_of(body), shoes_of(body)]


def hands_of(hand: Hand, rig: Rig) -> Part:
    """Returns both hands. The left hand is in the left half of the texture, and the right hand in the right half."""
    left = hand.part
    names = hand.rig.names
    count = len(left.positions)
    part = Part(
        "hands",
        "hand-skin",
        np.concatenate([left.positions, left.positions * [-1, 1, 1]]),
        np.concatenate([left.normals, left.normals * [-1, 1, 1]]),
        np.concatenate([left.uv * [0.5, 1], [1, 0] + left.uv * [-0.5, 1]]),
        np.concatenate([left.triangles, left.triangles[:, ::-1] + count]),
    )
    part.joints = np.concatenate([renumbered(left, names, rig), renumbered(left, names, rig, ".R")])
    part.weights = np.concatenate([left.weights, left.weights])
    return part


def follow_skeleton(neck: Neck, rig: Rig) -> None:
    """Skins the head to the joints of the figure."""
    neck.skin.joints = renumbered(neck.skin, neck.rig.names, rig)


def renumbered(part: Part, names: list[str], rig: Rig, side: str = ".L") -> np.ndarray:
    """Returns the indices of a part's joints in the skeleton of the figure. Joints without weight get the index 0."""
    numbers = np.array([rig.names.index(name.replace(".L", side)) for name in names])
    return np.where(part.weights > 0, numbers[part.joints], 0)


def halved(image: np.ndarray) -> np.ndarray:
    """Halves the width and height of a map."""
    rows = (image[::2] + image[1::2]) / 2
    return (rows[:, ::2] + rows[:, 1::2]) / 2


def two_hands(image: np.ndarray) -> np.ndarray:
    """Puts a map of the left hand and its mirror image side by side."""
    half = (image[:, ::2] + image[:, 1::2]) / 2
    return np.concatenate([half, half[:, ::-1]], axis=1)


def two_hands_normal(image: np.ndarray) -> np.ndarray:
    """Does the same as `two_hands` for a normal map, 0..1, whose x components change their sign in the mirror."""
    both = two_hands(image)
    middle = both.shape[1] // 2
    both[:, middle:, 0] = 1 - both[:, middle:, 0]
    return both
