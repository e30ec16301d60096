"""A part of a model: a mesh with one material and its targets."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Part:
    """A mesh. Triangles are counter-clockwise from outside, v points down as in glTF, lengths are in metres."""

    name: str
    material: str
    positions: np.ndarray  # (n, 3)
    normals: np.ndarray  # (n, 3) unit
    uv: np.ndarray | None  # (n, 2), None without maps
    triangles: np.ndarray  # (t, 3)
    colours: np.ndarray | None = None  # (n, 4) linear RGBA, multiplies the material's colour
    # By ARKit name: displacements (n, 3), and changes of normals (n, 3) or None for constant shading
    targets: dict[str, tuple[np.ndarray, np.ndarray | None]] = field(default_factory=dict)
    complete: bool = False  # whether the mesh gets a target for every ARKit name, even if nothing moves
    tangents: np.ndarray | None = None  # (n, 4), with a normal map; see tangents.py
    joints: np.ndarray | None = None  # (n, 4) indices into the skeleton's joints; see rig.py
    weights: np.ndarray | None = None  # (n, 4) integers, 65535 = 1
    parent: str | None = None  # the joint that moves an unskinned part


def triangulate(quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Cuts quads (q, 4) along the shorter diagonal, which keeps thin rims smooth. Returns triangles (2 q, 3)."""
    a, b, c, d = quads.T

    def gap(i, j):
        return np.linalg.norm(positions[i] - positions[j], axis=1)

    along_ac = (gap(a, c) <= gap(b, d))[:, None]
    first = np.where(along_ac, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(along_ac, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.stack([first, second], axis=1).reshape(-1, 3)
