"""Eyeballs with a cornea, and the lids' soft shade on them."""

from dataclasses import dataclass

import numpy as np

from ..part import Part
from ..source import Mesh
from .head import Head

# Offset from the centre of MakeHuman's flattened helper eye to the centre of a sphere that touches the lids.
OFFSET = np.array([0.0, -0.9e-3, 0.6e-3])  # metres
BITE = 0.35e-3  # metres that the ball overlaps the nearest lid rim, so that no gap remains at the far corner
IRIS_RADIUS = 5.85e-3  # an adult's iris measures 11.7 mm (Rüfer, Schröder, Erb 2005)
CORNEA_RISE = 1.1e-3  # metres that the cornea rises above the ball
REACH = np.radians(110)  # from the front pole; the rest of the ball is never visible
RINGS, SPOKES = 21, 36


@dataclass
class Ball:
    centre: np.ndarray
    radius: float
    limbus: float  # radians from the front pole to the edge of the iris


def ball_of(head: Head, mesh: Mesh, side: str) -> Ball:
    helper = np.unique(mesh.quads[mesh.groups == ("helper-l-eye" if side == "left" else "helper-r-eye")])
    points = head.base[helper]
    # Least squares sphere: |p|^2 = 2 p.c + (r^2 - |c|^2)
    system = np.c_[2 * points, np.ones(len(points))]
    centre = np.linalg.lstsq(system, (points**2).sum(axis=1), rcond=None)[0][:3] + OFFSET
    radius = np.linalg.norm(head.positions[lid_rim(head, side)] - centre, axis=1).min() + BITE
    return Ball(centre, radius, np.arcsin(IRIS_RADIUS / radius))


def lid_rim(head: Head, side: str) -> np.ndarray:
    """Returns the vertices shared by skin and eye socket, counter-clockwise from outside."""
    skin = np.unique(head.fine_quads[head.region == "skin"])
    socket = np.unique(head.fine_quads[head.region == f"socket-{side}"])
    rim = np.intersect1d(skin, socket)
    middle = head.positions[rim].mean(axis=0)
    angle = np.arctan2(head.positions[rim, 1] - middle[1], head.positions[rim, 0] - middle[0])
    return rim[np.argsort(angle)]


def _rise(tilt: np.ndarray, ball: Ball) -> np.ndarray:
    """Returns the cornea's height above the ball, metres, by angle from the front pole."""
    return CORNEA_RISE * np.clip(1 - (tilt / (1.08 * ball.limbus)) ** 2, 0, None) ** 1.2


def eye_part(head: Head, mesh: Mesh, side: str) -> Part:
    ball = ball_of(head, mesh, side)
    # Rings are denser around the iris, where cornea and ball meet.
    tilt = np.concatenate(
        [
            np.linspace(0, 1.25, RINGS * 2 // 3) * ball.limbus,
            np.linspace(1.25 * ball.limbus, REACH, RINGS - RINGS * 2 // 3 + 1)[1:],
        ]
    )
    turn = np.arange(SPOKES + 1) / SPOKES * 2 * np.pi
    tilts, turns = (x.ravel() for x in np.meshgrid(tilt, turn, indexing="ij"))
    rise = _rise(tilts, ball)
    axis = np.stack([np.sin(tilts) * np.cos(turns), np.sin(tilts) * np.sin(turns), np.cos(tilts)], axis=1)
    local = axis * (ball.radius + rise)[:, None]
    uv = 0.5 + 0.5 * (tilts / REACH)[:, None] * np.stack([np.cos(turns), -np.sin(turns)], axis=1)

    i, j = (x.ravel() for x in np.meshgrid(np.arange(len(tilt) - 1), np.arange(SPOKES), indexing="ij"))

    def at(ring, spoke):
        return ring * (SPOKES + 1) + spoke

    quads = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], axis=1)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    triangles = triangles[(tilts[triangles] > 0).sum(axis=1) > 1]  # without degenerate triangles at the pole
    normals = _grid_normals(local, triangles, len(tilt))

    targets = {}
    helper = np.unique(mesh.quads[mesh.groups == ("helper-l-eye" if side == "left" else "helper-r-eye")])
    for name, unit in head.units.items():
        if np.abs(unit[helper]).max() > 0:
            spin = _rotation(head.base[helper], head.base[helper] + unit[helper])
            targets[name] = (local @ spin.T - local, normals @ spin.T - normals)
    return Part(f"eye-{side}", "eye", local + ball.centre, normals, uv, triangles, targets=targets)


def shade_part(head: Head, mesh: Mesh) -> Part:
    """Builds dark transparent bands that move with the lids: their shade on the eyeballs."""
    parts = [_shade(head, ball_of(head, mesh, side), lid_rim(head, side)) for side in ("left", "right")]
    counts = np.cumsum([0] + [len(p[0]) for p in parts])

    def join(k):
        return np.concatenate([p[k] for p in parts])

    targets = {
        name: (np.concatenate([p[4].get(name, np.zeros_like(p[0])) for p in parts]), None)
        for name in sorted({name for p in parts for name in p[4]})
    }
    triangles = np.concatenate([p[3] + counts[i] for i, p in enumerate(parts)])
    return Part("lid-shade", "lid-shade", join(0), join(1), None, triangles, join(2), targets)


# Distance from the lid's rim in metres, and opacity under the upper and the lower lid.
SHADE = [(-0.8e-3, 0.85, 0.7), (0.2e-3, 0.75, 0.5), (1.2e-3, 0.42, 0.2), (2.6e-3, 0.16, 0.05), (4.6e-3, 0.0, 0.0)]


def _shade(head: Head, ball: Ball, rim: np.ndarray):
    def band(shift):
        edge = head.positions[rim] + shift
        inward = edge.mean(axis=0) - edge
        # On nearly closed lids the upper and the lower band end where they meet.
        room = np.abs(inward[:, 1:2]) + 0.4e-3
        inward[:, 0] *= (
            0.5  # makes the bands mostly vertical, so that the shade of the corners does not darken the lids
        )
        inward /= np.linalg.norm(inward, axis=1, keepdims=True)
        rows = np.concatenate([edge + inward * np.minimum(distance, room) for distance, _, _ in SHADE])
        direction = rows - ball.centre
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        tilt = np.arccos(np.clip(direction[:, 2], -1, 1))
        return direction * (ball.radius + _rise(tilt, ball) + 0.12e-3)[:, None]

    rest = band(np.zeros(3))
    normals = rest / np.linalg.norm(rest, axis=1, keepdims=True)
    upper = head.positions[rim, 1] > head.positions[rim, 1].mean()
    alpha = np.concatenate([np.where(upper, up, low) for _, up, low in SHADE])
    tint = np.array([0.10, 0.035, 0.025])  # linear; red from light through the lids
    colours = np.concatenate([np.tile(tint, (len(alpha), 1)), alpha[:, None]], axis=1)
    n = len(rim)
    i, j = (x.ravel() for x in np.meshgrid(np.arange(len(SHADE) - 1), np.arange(n), indexing="ij"))
    a, b, c, d = i * n + j, (i + 1) * n + j, (i + 1) * n + (j + 1) % n, i * n + (j + 1) % n
    triangles = np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)])
    targets = {}
    for name, (shift, _) in head.moves.items():
        if np.linalg.norm(shift[rim], axis=1).max() > 1e-4:
            moved = band(shift[rim])
            targets[name] = moved - rest
    return rest + ball.centre, normals, colours, triangles, targets


def _rotation(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Returns the (3, 3) rotation that best aligns two point clouds (W. Kabsch 1976)."""
    u, _, vt = np.linalg.svd((before - before.mean(axis=0)).T @ (after - after.mean(axis=0)))
    keep_handed = np.diag([1, 1, np.sign(np.linalg.det(vt.T @ u.T))])
    return vt.T @ keep_handed @ u.T


def _grid_normals(points: np.ndarray, triangles: np.ndarray, rings: int) -> np.ndarray:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    total = np.stack(
        [np.bincount(triangles.ravel(), np.repeat(face[:, k], 3), minlength=len(points)) for k in range(3)], 1
    )
    grid = total.reshape(rings, SPOKES + 1, 3)
    grid[:, 0] += grid[:, -1]  # both columns of the seam coincide
    grid[:, -1] = grid[:, 0]
    grid[0] = grid[0].sum(axis=0)
    total = grid.reshape(-1, 3)
    return total / np.linalg.norm(total, axis=1, keepdims=True)
