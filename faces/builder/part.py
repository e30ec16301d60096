"""Defines `Part`, a mesh of a model, and cuts quads into triangles."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Part:
    """A mesh with one material and its morph targets.

    Triangles are counter-clockwise from outside. v points down, as in glTF. Lengths are in metres.
    """

    name: str
    material: str
    positions: np.ndarray  # (n, 3)
    normals: np.ndarray  # (n, 3) unit
    uv: np.ndarray | None  # (n, 2); None if the material has no texture
    triangles: np.ndarray  # (t, 3)
    colours: np.ndarray | None = None  # (n, 4) linear RGBA; multiplies the material's colour
    # Morph targets by ARKit name: displacements (n, 3), and changes of normals (n, 3) or None if normals do not change.
    targets: dict[str, tuple[np.ndarray, np.ndarray | None]] = field(default_factory=dict)
    complete: bool = False  # whether the file gets a target for each ARKit name, even if the target moves nothing
    tangents: np.ndarray | None = None  # (n, 4); only for parts with a normal map
    joints: np.ndarray | None = None  # (n, 4) indices of joints in the skeleton
    weights: np.ndarray | None = None  # (n, 4) integer weights of `joints`; 65535 means 1
    parent: str | None = None  # name of the joint that moves an unskinned part


def triangulate(quads: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Cuts quads (q, 4) along their shorter diagonals, which keeps thin rims smooth. Returns triangles (2q, 3)."""
    a, b, c, d = quads.T

    def gap(i, j):
        return np.linalg.norm(positions[i] - positions[j], axis=1)

    along_ac = (gap(a, c) <= gap(b, d))[:, None]
    first = np.where(along_ac, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(along_ac, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.stack([first, second], axis=1).reshape(-1, 3)
