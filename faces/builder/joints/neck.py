"""Builds a head that turns on its neck. It is the head of human.glb without blendshapes, skinned to joints."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.spatial import cKDTree

from ..part import Part
from ..person.head import Head, build_head, skin_part
from ..rig import Rig, read_rig, strongest
from ..source import Mesh, Wheel

JOINTS = ["spine01", "neck01", "neck02", "neck03", "head"]

# The neck model uses the face's texture layout, with one change: its neck fills the lower third of the texture, not
# only a strip.
# `ROWS` maps v of the neck model's layout to v of the face's layout, and `ROWS_BACK` roughly inverts it.
ROWS = PchipInterpolator([0, 0.31, 0.58, 0.71, 1], [0, 0.40, 0.75, 0.85, 1])
ROWS_BACK = PchipInterpolator([0, 0.40, 0.75, 0.85, 1], [0, 0.31, 0.58, 0.71, 1])


@dataclass
class Neck:
    rig: Rig
    head: Head
    skin: Part  # uses the face's texture layout until `spread_out` is called
    vertices: np.ndarray  # (n,) for each vertex of the skin, its index in the subdivided head


def build_neck(wheel: Wheel, mesh: Mesh, shapes: dict[str, float], rest: dict[str, float]) -> Neck:
    head = build_head(wheel, mesh, shapes, rest)
    rig = read_rig(wheel, mesh, head.base, JOINTS, lambda name: np.array([0.0, 0.0, 1.0]))
    skin, vertices = skin_part(head, dense_neck=True)
    skin.joints, skin.weights = strongest((head.matrix @ rig.weights[head.used])[vertices])
    without_targets(skin)
    return Neck(rig, head, skin, vertices)


def without_targets(part: Part) -> Part:
    part.targets, part.complete = {}, False
    return part


def follow_body(part: Part, neck: Neck, mesh: Mesh) -> None:
    """Skins a part. Its joint weights are interpolated from the nearest vertices of the body."""
    body = np.unique(mesh.quads[mesh.groups == "body"])
    gap, nearest = cKDTree(neck.head.base[body]).query(part.positions, k=4)
    nearness = 1 / (gap + 1e-4)
    weights = (neck.rig.weights[body[nearest]] * (nearness / nearness.sum(axis=1, keepdims=True))[..., None]).sum(
        axis=1
    )
    part.joints, part.weights = strongest(weights)


def spread_out(skin: Part) -> None:
    """Converts the skin's uv from the face's texture layout to the layout with the larger neck."""
    skin.uv = np.stack([skin.uv[:, 0], np.round(_solved(skin.uv[:, 1]), 7)], axis=1)


def spread_map(image: np.ndarray) -> np.ndarray:
    """Resamples a map from the face's texture layout to the layout with the larger neck."""
    size = len(image)
    rows = np.clip(ROWS((np.arange(size) + 0.5) / size) * size - 0.5, 0, size - 1)
    low = np.minimum(rows.astype(int), size - 2)
    t = (rows - low).reshape(-1, *[1] * (image.ndim - 1))
    return image[low] * (1 - t) + image[low + 1] * t


def _solved(face: np.ndarray) -> np.ndarray:
    """Inverts `ROWS` by Newton's method."""
    slope = ROWS.derivative()
    v = ROWS_BACK(face)
    for _ in range(8):
        v = np.clip(v - (ROWS(v) - face) / slope(v), 0, 1)
    return v
