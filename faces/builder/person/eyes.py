"""Builds the eyeballs, each with a cornea, and transparent bands on the eyeballs that imitate the lids' shadow."""

from dataclasses import dataclass

import numpy as np

from ..part import Part
from ..source import Mesh
from .head import Head

# Offset in metres from the centre of MakeHuman's helper eye, which is flattened, to the centre of a sphere that touches
# the lids.
OFFSET = np.array([0.0, -0.9e-3, 0.6e-3])
# Metres by which the eyeball's radius exceeds the distance from its centre to the nearest point of the lids' edge. The
# overlap closes gaps at the corners of the eye.
BITE = 0.35e-3
IRIS_RADIUS = 5.85e-3  # metres; an adult's iris has a diameter of 11.7 mm (Rüfer, Schröder, Erb 2005)
CORNEA_RISE = 1.1e-3  # height of the cornea above the sphere, metres
REACH = np.radians(110)  # angle from the front pole to the end of the mesh; the rest is never visible
RINGS, SPOKES = 21, 36


@dataclass
class Ball:
    centre: np.ndarray
    radius: float
    limbus: float  # angle from the front pole to the edge of the iris, radians


def ball_of(head: Head, mesh: Mesh, side: str) -> Ball:
    helper = np.unique(mesh.quads[mesh.groups == ("helper-l-eye" if side == "left" else "helper-r-eye")])
    points = head.base[helper]
    # Fits a sphere with centre c and radius r by least squares: dot(p, p) = 2 * dot(p, c) + r**2 - dot(c, c).
    system = np.c_[2 * points, np.ones(len(points))]
    centre = np.linalg.lstsq(system, (points**2).sum(axis=1), rcond=None)[0][:3] + OFFSET
    radius = np.linalg.norm(head.positions[lid_rim(head, side)] - centre, axis=1).min() + BITE
    return Ball(centre, radius, np.arcsin(IRIS_RADIUS / radius))


def lid_rim(head: Head, side: str) -> np.ndarray:
    """Returns the vertices on the edge of the lids, counter-clockwise from outside. Skin and eye socket share them."""
    skin = np.unique(head.fine_quads[head.region == "skin"])
    socket = np.unique(head.fine_quads[head.region == f"socket-{side}"])
    rim = np.intersect1d(skin, socket)
    middle = head.positions[rim].mean(axis=0)
    angle = np.arctan2(head.positions[rim, 1] - middle[1], head.positions[rim, 0] - middle[0])
    return rim[np.argsort(angle)]


def _rise(tilt: np.ndarray, ball: Ball) -> np.ndarray:
    """Returns the height of the cornea above the sphere in metres. `tilt`: angles from the front pole, radians."""
    return CORNEA_RISE * np.clip(1 - (tilt / (1.08 * ball.limbus)) ** 2, 0, None) ** 1.2


def eye_part(head: Head, mesh: Mesh, side: str) -> Part:
    ball = ball_of(head, mesh, side)
    # Rings are denser over the iris and its edge, where the cornea meets the sphere.
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
    # Removes the degenerate triangles at the pole.
    triangles = triangles[(tilts[triangles] > 0).sum(axis=1) > 1]
    normals = _grid_normals(local, triangles, len(tilt))

    targets = {}
    helper = np.unique(mesh.quads[mesh.groups == ("helper-l-eye" if side == "left" else "helper-r-eye")])
    for name, unit in head.units.items():
        if np.abs(unit[helper]).max() > 0:
            spin = _rotation(head.base[helper], head.base[helper] + unit[helper])
            targets[name] = (local @ spin.T - local, normals @ spin.T - normals)
    return Part(f"eye-{side}", "eye", local + ball.centre, normals, uv, triangles, targets=targets)


def shade_part(head: Head, mesh: Mesh) -> Part:
    """Builds dark transparent bands on the eyeballs. They move with the lids and imitate the lids' shadow."""
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


# Rows of a band: distance from the edge of the lid in metres, opacity at the upper lid, and opacity at the lower lid.
# Distances are positive towards the middle of the eye's opening, and negative under the lid.
SHADE = [(-0.8e-3, 0.85, 0.7), (0.2e-3, 0.75, 0.5), (1.2e-3, 0.42, 0.2), (2.6e-3, 0.16, 0.05), (4.6e-3, 0.0, 0.0)]


def _shade(head: Head, ball: Ball, rim: np.ndarray):
    def band(shift):
        edge = head.positions[rim] + shift
        inward = edge.mean(axis=0) - edge
        # If the eye is nearly closed, the bands end where the upper band meets the lower band.
        longest = np.abs(inward[:, 1:2]) + 0.4e-3
        # Makes the bands nearly vertical, so that bands at the corners of the eye do not darken the lids.
        inward[:, 0] *= 0.5
        inward /= np.linalg.norm(inward, axis=1, keepdims=True)
        rows = np.concatenate([edge + inward * np.minimum(distance, longest) for distance, _, _ in SHADE])
        direction = rows - ball.centre
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        tilt = np.arccos(np.clip(direction[:, 2], -1, 1))
        return direction * (ball.radius + _rise(tilt, ball) + 0.12e-3)[:, None]

    rest = band(np.zeros(3))
    normals = rest / np.linalg.norm(rest, axis=1, keepdims=True)
    upper = head.positions[rim, 1] > head.positions[rim, 1].mean()
    alpha = np.concatenate([np.where(upper, up, low) for _, up, low in SHADE])
    tint = np.array([0.10, 0.035, 0.025])  # linear; reddish, because some light shines through the lids
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
    grid[:, 0] += grid[:, -1]  # the first and the last column have the same positions
    grid[:, -1] = grid[:, 0]
    grid[0] = grid[0].sum(axis=0)
    total = grid.reshape(-1, 3)
    return total / np.linalg.norm(total, axis=1, keepdims=True)
