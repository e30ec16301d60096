"""A part of the face on its way into the file: one mesh with one material and its targets."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Part:
    """Triangles run counter-clockwise seen from outside; uv has v downwards, as in glTF; lengths are in metres."""

    name: str
    material: str
    positions: np.ndarray  # (n, 3)
    normals: np.ndarray  # (n, 3) unit
    uv: np.ndarray | None  # (n, 2), None where no map is laid on
    triangles: np.ndarray  # (t, 3)
    colours: np.ndarray | None = None  # (n, 4) linear red, green, blue, alpha; multiplies the material's colour
    # ARKit name -> displacement of every vertex, and change of every normal (None where shading need not follow)
    targets: dict[str, tuple[np.ndarray, np.ndarray | None]] = field(default_factory=dict)
    complete: bool = False  # list every ARKit name, also those that do not move this part
    tangents: np.ndarray | None = None  # (n, 4), where a normal map is laid on; see tangents.py
    joints: np.ndarray | None = None  # (n, 4) into the skeleton's joints, of what they deform; see rig.py
    weights: np.ndarray | None = None  # (n, 4) in parts of 65535
    parent: str | None = None  # the joint to which what no joint deforms is fixed


def triangulate(quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Cuts every quad along its shorter diagonal, which keeps thin rims (lids, lips, ears) smooth."""
    a, b, c, d = quads.T
    gap = lambda i, j: np.linalg.norm(positions[i] - positions[j], axis=1)
    along_ac = (gap(a, c) <= gap(b, d))[:, None]
    first = np.where(along_ac, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(along_ac, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.stack([first, second], axis=1).reshape(-1, 3)
