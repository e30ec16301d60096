"""Builds the teeth with gums, the tongue, and the linings of the mouth and the eye sockets.

MakeHuman's body has helper meshes for both rows of teeth and for the tongue. This module uses only the arch and
the motion of the helper teeth.
"""

import numpy as np

from ..part import Part, triangulate
from ..source import Mesh
from ..subdivide import catmull_clark, vertex_normals
from .head import Head, mouth_lining, socket_lining

# Width and height of the crowns of half a row, from the central incisor to the back, millimetres (Wheeler's Dental
# Anatomy, rounded).
UPPER = [(8.6, 10.4), (6.7, 9.2), (7.6, 10.2), (7.0, 8.6), (6.8, 8.0), (9.8, 7.4)]
LOWER = [(5.4, 8.8), (5.9, 9.2), (6.8, 10.4), (7.0, 8.6), (7.1, 8.0)]
INCISORS_AND_CANINES = 3
LIGHT = [1.0, 0.97, 0.82, 0.45, 0.16, 0.08]  # brightness of each tooth; cheeks shade those further back
ARCH_WIDTH = {"upper": 0.90, "lower": 0.81}  # width of the dental arch, as a fraction of the helper's width
ARCH_INSET = 1.5e-3  # distance of the arch behind the helper's front, metres
# Metres by which the tongue is lowered. Otherwise it would fill the open mouth up to the palate.
TONGUE_DROP = 3e-3
# Rise of the biting edges towards the back, as a fraction of the helper's rise. With 1, molars would be visible at the
# corners of the mouth.
SPEE = 0.25
OVERBITE = 1.2e-3  # metres by which both rows are lowered, so that a smile shows the upper row
ENAMEL, ENAMEL_AT_GUM, GUM = (0.74, 0.66, 0.52), (0.62, 0.48, 0.32), (0.42, 0.13, 0.11)  # linear
LINING, THROAT, TONGUE = (0.36, 0.11, 0.09), (0.05, 0.012, 0.01), (0.44, 0.16, 0.14)
LID_RIM = (0.26, 0.085, 0.065)


def teeth_part(head: Head, mesh: Mesh, jaw: str) -> Part:
    helper = np.unique(mesh.quads[mesh.groups == f"helper-{jaw}-teeth"])
    points = head.base[helper]
    arch = _arch(points, jaw)
    away = 1 if jaw == "upper" else -1  # direction of y from the biting edge to the gum
    crowns = UPPER if jaw == "upper" else LOWER

    pieces = []
    for side in (1, -1):
        travelled = 0.15e-3
        for number, (width, height) in enumerate(crowns):
            width, height = width * 1e-3, height * 1e-3
            pieces.append(_crown(arch, side, travelled + width / 2, width, height, away, number))
            travelled += width + 0.1e-3
    pieces.append(_gum(arch, sum(w for w, _ in crowns) * 1e-3, away))

    counts = np.cumsum([0] + [len(p[0]) for p in pieces])
    positions = np.concatenate([p[0] for p in pieces])
    quads = np.concatenate([p[1] + counts[i] for i, p in enumerate(pieces)])
    colours = np.concatenate([p[2] for p in pieces])
    targets = {}
    for name, unit in head.units.items():
        if np.linalg.norm(unit[helper], axis=1).max() > 1e-3:
            # The jaw moves rigidly, so an affine map that is fitted to the helper's motion moves all teeth.
            system = np.c_[points, np.ones(len(points))]
            fit = np.linalg.lstsq(system, unit[helper], rcond=None)[0]
            shift = np.c_[positions, np.ones(len(positions))] @ fit
            targets[name] = (shift, None)
    normals = vertex_normals(positions, quads)
    triangles = triangulate(quads, positions)
    return Part(f"teeth-{jaw}", "teeth", positions, normals, None, triangles, colours, targets)


def tongue_part(head: Head, mesh: Mesh) -> Part:
    used, quads = np.unique(mesh.quads[mesh.groups == "helper-tongue"], return_inverse=True)
    matrix, fine = catmull_clark(quads.reshape(-1, 4), len(used))
    positions = matrix @ head.base[used] - [0, TONGUE_DROP, 0]
    normals = vertex_normals(positions, fine)
    targets = {}
    for name, unit in head.units.items():
        if np.abs(unit[used]).max() > 0:
            shift = matrix @ unit[used]
            targets[name] = (shift, vertex_normals(positions + shift, fine) - normals)
    colours = _fade(positions, TONGUE, THROAT)
    return Part("tongue", "tongue", positions, normals, None, triangulate(fine, positions), colours, targets)


def mouth_part(head: Head) -> Part:
    part = mouth_lining(head)
    part.colours = _fade(part.positions, LINING, THROAT)
    return part


def socket_part(head: Head) -> Part:
    part = socket_lining(head)
    part.colours = np.tile([*LID_RIM, 1.0], (len(part.positions), 1))
    return part


def _fade(positions, front, back) -> np.ndarray:
    """Returns vertex colours (n, 4) that change from `front` to `back` towards the throat."""
    z = positions[:, 2]
    t = np.clip((z.max() - z) / 0.045, 0, 1)[:, None] ** 0.8
    return np.concatenate([(1 - t) * np.array(front) + t * np.array(back), np.ones((len(z), 1))], axis=1)


def _arch(points: np.ndarray, jaw: str) -> np.ndarray:
    """Returns points of half the dental arch, from the middle to the back, (200, 4).

    Columns are the arc length, x, the height of the biting edge and z, in metres.
    """
    front, wide = points[:, 2].max(), np.abs(points[:, 0]).max()
    deep = front - points[:, 2].min()
    t = np.linspace(0, np.pi / 2, 200)
    x = ARCH_WIDTH[jaw] * wide * np.sin(t) ** 0.9
    z = front - ARCH_INSET - (deep - ARCH_INSET) * (1 - np.cos(t)) ** 0.95
    middle, back = np.abs(points[:, 0]) < 12e-3, points[:, 2] < points[:, 2].min() + 8e-3
    extreme = np.min if jaw == "upper" else np.max
    # The biting edges rise towards the back (curve of Spee).
    at_front, at_back = extreme(points[middle, 1]), extreme(points[back, 1])
    edge = at_front - OVERBITE + SPEE * (at_back - at_front) * (front - z) / deep
    along = np.concatenate([[0], np.cumsum(np.hypot(np.diff(x), np.diff(z)))])
    return np.stack([along, x, edge, z], axis=1)


def _frame(arch: np.ndarray, side: int, at: float):
    """Returns the point on the biting edge at arc length `at`, the direction of the arch, and the outward direction."""

    def point(d):
        return np.array([np.interp(d, arch[:, 0], arch[:, k]) for k in (1, 2, 3)]) * [side, 1, 1]

    here, ahead = point(at), point(at + 1e-4)
    tangent = (ahead - here) * [1, 0, 1]
    tangent /= np.linalg.norm(tangent)
    return here, tangent, np.array([-tangent[2], 0, tangent[0]]) * side


def _crown(arch, side, at, width, height, away, number):
    """Builds a crown by sweeping a superellipse from the gum to the biting edge.

    It is narrower at the gum. The biting edge is thin on incisors and canines, and thick on teeth further back.
    """
    here, tangent, outward = _frame(arch, side, at)
    levels, spokes = 6, 12
    front = number < INCISORS_AND_CANINES
    depth = 0.0066 if front else 0.0088
    s = np.linspace(0, 1, levels)  # 0 at the gum, 1 at the biting edge
    turn = np.arange(spokes) / spokes * 2 * np.pi
    power = 0.62  # exponent of the superellipse, nearly a rectangle
    cx = np.sign(np.cos(turn)) * np.abs(np.cos(turn)) ** power
    cz = np.sign(np.sin(turn)) * np.abs(np.sin(turn)) ** power
    wide = width / 2 * (0.80 + 0.2 * np.sqrt(np.clip(s * 1.6, 0, 1))) * np.where(s > 0.9, 0.94, 1)
    thick = depth / 2 * ((1 - 0.62 * s**1.5) if front else (1 - 0.12 * s**3))
    wide[-1] *= 0.9
    thick[-1] *= 0.7
    up = away * height * (1 - s) * 1.12 - away * 0.2e-3
    lean = (1 - s) * -0.0006
    rows = [
        here
        + tangent * (cx * wide[k])[:, None]
        + outward * (cz * thick[k] + lean[k] - depth / 2)[:, None]
        + np.array([0, up[k], 0])
        for k in range(levels)
    ]
    tip = here + outward * (lean[-1] - depth / 2) + np.array([0, up[-1] - away * 0.25e-3, 0])
    points = np.concatenate([*rows, np.repeat(tip[None], spokes, axis=0) + 0.25 * (rows[-1] - rows[-1].mean(axis=0))])
    tint = (
        np.concatenate(
            [
                np.tile((1 - k) * np.array(ENAMEL_AT_GUM) + k * np.array(ENAMEL), (spokes, 1))
                for k in [*np.clip(s * 2.2, 0, 1), 1]
            ]
        )
        * LIGHT[number]
    )
    return points, _tube(points, levels + 1, spokes), np.c_[tint, np.ones(len(tint))]


def _gum(arch, length, away):
    spokes, stations = 10, 32
    rows, tint = [], []
    for at in np.linspace(-length, length, stations):
        here, _, outward = _frame(arch, 1 if at >= 0 else -1, abs(at))
        turn = np.arange(spokes) / spokes * 2 * np.pi
        height, depth = 0.0052, 0.0054
        y = away * (0.0128 - 0.0016 * abs(at) / length) + height * np.sin(turn)
        rows.append(here + outward * (depth * np.cos(turn) - 0.0034)[:, None] + np.stack([0 * y, y, 0 * y], 1))
        tint.append(np.tile(np.array(GUM) * (1 - 0.92 * abs(at) / length), (spokes, 1)))
    tint = np.concatenate(tint)
    points = np.concatenate(rows)
    return points, _tube(points, stations, spokes), np.c_[tint, np.ones(len(tint))]


def _tube(points: np.ndarray, rows: int, spokes: int) -> np.ndarray:
    i, j = (x.ravel() for x in np.meshgrid(np.arange(rows - 1), np.arange(spokes), indexing="ij"))
    a, b = i * spokes + j, i * spokes + (j + 1) % spokes
    quads = np.stack([a, b, b + spokes, a + spokes], axis=1)
    axis = points.reshape(rows, spokes, 3).mean(axis=1)
    outward = points[quads].mean(axis=1) - (axis[i] + axis[i + 1]) / 2
    facing = np.cross(points[quads[:, 2]] - points[quads[:, 0]], points[quads[:, 3]] - points[quads[:, 1]])
    return quads if (outward * facing).sum() > 0 else quads[:, ::-1]
