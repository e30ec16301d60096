"""Builds the left hand with a part of the forearm and a cuff.

The hand is cut out of MakeHuman's body, subdivided once, unwrapped to a texture layout and skinned.
"""

from dataclasses import dataclass

import numpy as np

from ..layout import borders
from ..part import Part, triangulate
from ..person.head import islands
from ..rig import Rig, read_rig, strongest, unit
from ..source import Mesh, Wheel
from ..subdivide import catmull_clark, vertex_normals

FINGERS = range(1, 6)  # 1 is the thumb
JOINTS = ["lowerarm01.L", "lowerarm02.L", "wrist.L", *[f"metacarpal{k}.L" for k in range(1, 5)]] + [
    f"finger{finger}-{k}.L" for finger in FINGERS for k in (1, 2, 3)
]
ARM_RINGS = 6  # number of rings of quads, counted from the hand up the forearm, that belong to the skin
CUFF_RINGS = 9  # number of rings from the hand to the end of the cuff
CUFF_COVERS = 3  # number of rings of skin under the cuff
EASE, HEM = 2.2e-3, 3.0e-3  # distance from the skin to the cuff, and depth of the cuff's hem, metres
NAIL_MIDDLE = 0.72  # position of a nail's middle, as a fraction of the way from the last joint to the finger tip
NAIL_QUADS = 0.25  # minimum size of a nail's quads, relative to the quad in its middle
MARGIN = 0.012  # margin around the hand in the texture, uv
STRIP = (0.015, 0.015, 0.505, 0.290)  # rectangle of the forearm in the texture: u0, v0, u1, v1


@dataclass
class Hand:
    rig: Rig
    part: Part
    cuff: Part
    inner: np.ndarray  # (n,) cosine between the normal and the bend direction: 1 on the palm, -1 on the back
    nails: np.ndarray  # (q, 4, 2) uv of the nails' quads
    nail_way: np.ndarray  # (n,) position along the nail: 0 at its root, 1 at its free edge


def build_hand(wheel: Wheel, mesh: Mesh, shapes: dict[str, float]) -> Hand:
    base = wheel.blended(shapes)
    rig = read_rig(wheel, mesh, base, JOINTS, Inwards(wheel, mesh, base))
    island = _hand_island(mesh)
    rings = _arm_rings(mesh, island)
    quads = np.concatenate([mesh.quads[island], *rings[:ARM_RINGS]])
    uv, uv_quads = _layout(mesh, island, rings[:ARM_RINGS], base)

    used, index = np.unique(quads, return_inverse=True)
    matrix, fine = catmull_clark(index.reshape(-1, 4), len(used))
    positions = np.round(matrix @ base[used], 7)
    normals = vertex_normals(positions, fine)
    uv_matrix, uv_fine = catmull_clark(uv_quads, len(uv))
    fine_uv = np.round(uv_matrix @ uv, 7)
    pairs, corner = np.unique(np.stack([fine.ravel(), uv_fine.ravel()], 1), axis=0, return_inverse=True)
    vertex = pairs[:, 0]
    weights = (matrix @ rig.weights[used])[vertex]
    triangles = triangulate(corner.reshape(-1, 4), positions[vertex])
    part = Part("skin", "skin", positions[vertex], normals[vertex], fine_uv[pairs[:, 1]], triangles)
    part.joints, part.weights = strongest(weights)
    inner = (part.normals * np.einsum("nj,jk->nk", weights, rig.frames[:, :, 2])).sum(axis=1)
    way, nails = np.zeros(len(vertex)), []
    for finger, nail in zip(FINGERS, _nails(rig, base, quads), strict=True):
        nails.append(corner.reshape(-1, 4, 4)[nail].reshape(-1, 4))
        joint = rig.names.index(f"finger{finger}-3.L")
        along = (part.positions - rig.positions[joint]) @ rig.frames[joint][:, 1]
        low, high = along[nails[-1]].min(), along[nails[-1]].max()
        way = np.where(weights[:, joint] > 0.5, np.clip((along - low) / (high - low), 0, 1), way)
    cuff = _cuff(rig, base, rings[ARM_RINGS - CUFF_COVERS : CUFF_RINGS])
    return Hand(rig, part, cuff, inner, part.uv[np.concatenate(nails)], way)


def palm_frame(rig: Rig) -> np.ndarray:
    """Returns the axes of the palm as the columns of a (3, 3) matrix.

    x points towards the little finger, y towards the finger tips, and z out of the palm.
    """
    wrist = rig.at("wrist.L")
    z = unit(np.cross(rig.at("finger5-1.L") - wrist, rig.at("finger2-1.L") - wrist))
    y = unit(rig.at("finger3-1.L") - wrist)
    return np.stack([unit(np.cross(y, z)), y, z], axis=1)


class Inwards:
    """Maps the name of a joint to its bend direction. Fingers bend towards the palm, and the thumb bends across it."""

    def __init__(self, wheel: Wheel, mesh: Mesh, base: np.ndarray):
        # This rig gets an arbitrary bend direction, because only its positions and bone directions are used.
        still = read_rig(wheel, mesh, base, JOINTS, lambda name: np.array([-1.0, 0.0, 0.0]))
        self.palm = palm_frame(still)[:, 2]
        # The thumb is slightly bent at rest. The cross products of its bones give its axis of rotation.
        along = [still.frames[JOINTS.index(f"finger1-{k}.L")][:, 1] for k in (1, 2, 3)]
        axis = unit(unit(np.cross(along[0], along[1])) + unit(np.cross(along[1], along[2])))
        self.thumb = [np.cross(axis, y) for y in along]

    def __call__(self, name: str) -> np.ndarray:
        return self.thumb[int(name[8]) - 1] if name.startswith("finger1-") else self.palm


def _hand_island(mesh: Mesh) -> np.ndarray:
    """Returns the indices of the quads of the left hand: the UV island of MakeHuman's layout that has a finger tip."""
    body = np.flatnonzero(mesh.groups == "body")
    island = islands(mesh, body)
    tip = mesh.positions[np.unique(mesh.quads[mesh.groups == "joint-l-finger-3-4"])].mean(axis=0)
    nearest = np.argmin(np.linalg.norm(mesh.positions[mesh.quads[body]].mean(axis=1) - tip, axis=1))
    return body[island == island[nearest]]


def _arm_rings(mesh: Mesh, island: np.ndarray) -> list[np.ndarray]:
    """Collects rings of quads around the arm, from the edge of the hand upwards."""
    body = np.flatnonzero(mesh.groups == "body")
    taken = np.isin(body, island)
    rings = []
    for _ in range(CUFF_RINGS):
        reached = np.isin(mesh.quads[body], np.unique(mesh.quads[body[taken]])).any(axis=1) & ~taken
        rings.append(mesh.quads[body[reached]])
        taken |= reached
    return rings


def _layout(mesh: Mesh, island: np.ndarray, rings: list[np.ndarray], base: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Creates the texture layout: MakeHuman's UV island of the hand, enlarged, and the forearm as a strip.

    Returns uv (n, 2), v down, and quads (f, 4) of indices into uv.
    """
    used, hand = np.unique(mesh.uv_quads[island], return_inverse=True)
    source = mesh.uv[used] * [1, -1]
    low, high = source.min(axis=0), source.max(axis=0)
    uv = MARGIN + (source - low) / (high - low).max() * (1 - 2 * MARGIN)
    uv[:, 1] += 1 - MARGIN - uv[:, 1].max()

    loops = [max(borders(mesh.quads[island]), key=len)]
    for ring in rings:
        loops.append(_next_loop(loops[-1], ring))
    # Each loop around the arm starts and ends at the UV seam, which is on the side of the little finger.
    seam = np.argmin(base[loops[0], 1] - base[loops[0], 0] + base[loops[0], 2])
    grid = np.array([np.append(np.roll(loop, -seam), loop[seam]) for loop in loops])
    around = np.linalg.norm(np.diff(base[grid], axis=1), axis=2).mean(axis=0)
    along = np.linalg.norm(np.diff(base[grid], axis=0), axis=2).mean(axis=1)

    def fractions(steps):
        return np.concatenate([[0], np.cumsum(steps)]) / steps.sum()

    u0, v0, u1, v1 = STRIP
    u, v = np.meshgrid(u0 + (u1 - u0) * fractions(around), v1 + (v0 - v1) * fractions(along))
    strip = np.stack([u.ravel(), v.ravel()], axis=1)

    column = {(r, grid[r, c]): c for r in range(len(grid)) for c in range(grid.shape[1] - 1)}
    width = grid.shape[1]
    quads = []
    for r, ring in enumerate(rings):
        for quad in ring:
            cells = [(r + k, column[r + k, vertex]) for vertex in quad for k in (0, 1) if (r + k, vertex) in column]
            wraps = max(c for _, c in cells) - min(c for _, c in cells) > 1
            quads.append([row * width + (width - 1 if wraps and c == 0 else c) for row, c in cells])
    strip_quads = np.array(quads)
    if _turns(strip, strip_quads) != _turns(uv, hand.reshape(-1, 4)):
        strip[:, 0] = u0 + u1 - strip[:, 0]
    return np.concatenate([uv, strip]), np.concatenate([hand.reshape(-1, 4), strip_quads + len(uv)])


def _next_loop(loop: np.ndarray, ring: np.ndarray) -> np.ndarray:
    """Returns the second border of a ring of quads, whose first border is `loop`.

    The edges across the ring connect vertices with the same index in both borders.
    """
    across = {}
    for quad in ring:
        for a, b in zip(quad, np.roll(quad, -1), strict=True):
            if (a in loop) != (b in loop):
                across[a if a in loop else b] = b if a in loop else a
    return np.array([across[vertex] for vertex in loop])


def _turns(uv: np.ndarray, quads: np.ndarray) -> bool:
    a, b, c, d = (uv[quads[:, k]] for k in range(4))
    p, q = c - a, d - b
    return (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum() > 0


def _nails(rig: Rig, base: np.ndarray, quads: np.ndarray) -> list[np.ndarray]:
    """Finds the quads of each nail.

    Starts with the quad in the nail's middle, and adds adjacent quads that are wide and have similar normals. The
    groove around a nail has narrow quads, and the normals at the finger tip differ.
    """
    corners = base[quads]
    centre = corners.mean(axis=1)
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    size = np.linalg.norm(normal, axis=1, keepdims=True)
    normal /= size
    nails = []
    for finger in FINGERS:
        joint = rig.names.index(f"finger{finger}-3.L")
        on_finger = rig.weights[quads, joint].min(axis=1) > 0.5
        local = (centre - rig.positions[joint]) @ rig.frames[joint]
        on_back = on_finger & (normal @ -rig.frames[joint][:, 2] > 0.6)
        middle = np.hypot(local[:, 0], local[:, 1] - NAIL_MIDDLE * local[on_finger, 1].max())
        seed = np.argmin(np.where(on_back, middle, np.inf))
        fits = on_finger & (size[:, 0] > NAIL_QUADS * size[seed, 0]) & (normal @ normal[seed] > 0.75)
        nail, edge = {seed}, [seed]
        while edge:
            here = edge.pop()
            across = centre - centre[here]
            rises = (across @ normal[here]) / np.maximum(np.linalg.norm(across, axis=1), 1e-9)
            neighbours = np.flatnonzero(fits & (np.isin(quads, quads[here]).sum(axis=1) == 2) & (rises < 0.06))
            edge += [quad for quad in neighbours if quad not in nail]
            nail |= set(neighbours)
        nails.append(np.array(sorted(nail)))
    return nails


def _cuff(rig: Rig, base: np.ndarray, rings: list[np.ndarray]) -> Part:
    """Builds a cuff around the end of the forearm. Its hem is folded inwards to the skin."""
    quads = np.concatenate(rings)
    used, index = np.unique(quads, return_inverse=True)
    matrix, fine = catmull_clark(index.reshape(-1, 4), len(used))
    body = matrix @ base[used]
    out = vertex_normals(body, fine)
    weights = matrix @ rig.weights[used]
    hand = rig.at("wrist.L")
    wrist = min(borders(fine), key=lambda loop: np.linalg.norm(body[loop].mean(axis=0) - hand))
    count = len(body)
    inner = count + np.arange(len(wrist))
    positions = np.concatenate([body + out * EASE, body[wrist] + out[wrist] * (EASE - HEM)])
    quads = np.concatenate([fine, np.stack([np.roll(wrist, -1), wrist, inner, np.roll(inner, -1)], axis=1)])
    part = Part("cuff", "shirt", positions, vertex_normals(positions, quads), None, triangulate(quads, positions))
    part.joints, part.weights = strongest(np.concatenate([weights, weights[wrist]]))
    return part
