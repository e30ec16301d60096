"""A part of a model: one mesh with one material and its targets."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Part:
    """Triangles are counter-clockwise seen from outside; v is down, as in glTF; lengths are in metres."""

    name: str
    material: str
    positions: np.ndarray  # (n, 3)
    normals: np.ndarray  # (n, 3) unit
    uv: np.ndarray | None  # (n, 2), None without maps
    triangles: np.ndarray  # (t, 3)
    colours: np.ndarray | None = None  # (n, 4) linear RGBA, multiplies the material's colour
    # ARKit name -> (n, 3) displacements and (n, 3) changes of normals (None where shading need not follow)
    targets: dict[str, tuple[np.ndarray, np.ndarray | None]] = field(default_factory=dict)
    complete: bool = False  # lists every ARKit name, even those that do not move this part
    tangents: np.ndarray | None = None  # (n, 4), where there is a normal map; see tangents.py
    joints: np.ndarray | None = None  # (n, 4) indices into the skeleton's joints; see rig.py
    weights: np.ndarray | None = None  # (n, 4) integers, 65535 = 1
    parent: str | None = None  # the joint that moves an unskinned part


def triangulate(quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """(2 q, 3) triangles of (q, 4) quads, cut along the shorter diagonal: thin rims (lids, lips, ears) stay smooth."""
    a, b, c, d = quads.T

    def gap(i, j):
        return np.linalg.norm(positions[i] - positions[j], axis=1)

    along_ac = (gap(a, c) <= gap(b, d))[:, None]
    first = np.where(along_ac, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(along_ac, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.stack([first, second], axis=1).reshape(-1, 3)
