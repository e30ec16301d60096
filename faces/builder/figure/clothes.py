"""Builds shirt, trousers and shoes from the tights of MakeHuman's figure, a helper mesh around the body."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.spatial import cKDTree

from ..layout import borders
from ..part import Part, triangulate
from ..rig import Rig, strongest
from ..source import Mesh
from ..subdivide import catmull_clark, vertex_normals
from .skeleton import SIDES, Limb
from .unwrap import Chart, unwrap

# Lengths are in metres.
SHIRT_HEM = 0.045  # height of the shirt's hem above the hip joints
WAIST = 0.085  # height of the trousers' upper edge above the hip joints
NECKLINE = 0.012  # height of the shirt's neckline above the neck's lowest joint
ANKLE = 0.045  # height of the trousers' hem above the ankle
SHOE_TOP = 0.075  # height of the shoes' upper edge above the ankle
CROTCH = 0.045  # distance from the hip joints down to the edge of the legs in the texture
HEM = 0.006  # depth of the hems that are folded inwards
ROUNDS = 24  # rounds of smoothing, which hide the shape of muscles


@dataclass
class Body:
    """The figure's shape, with the skin that clothes must cover."""

    rig: Rig
    mesh: Mesh
    base: np.ndarray  # (n, 3) vertices of the base figure

    def side_weight(self, vertices: np.ndarray, *bones: str) -> np.ndarray:
        """Returns the total weight of joints whose names start with one of `bones`."""
        own = [i for i, name in enumerate(self.rig.names) if name.startswith(bones)]
        return self.rig.weights[vertices][:, own].sum(axis=1)


def shirt_of(body: Body) -> Part:
    hips = body.rig.at("upperleg01.L")[1]
    top = body.rig.at("neck01")[1] + NECKLINE

    def is_shirt(centre, leg, arm):
        return (arm > 0.5) | ((centre[:, 1] > hips + SHIRT_HEM) & (centre[:, 1] < top))

    arms = [Limb(body.rig, "arm", side) for side in SIDES]
    cloth = _Cloth(body, is_shirt, keep=_before_wrist(arms))
    ease = 0.007 + 0.010 * np.clip((hips + 0.30 - cloth.positions[:, 1]) / 0.25, 0, 1) * (1 - cloth.arm)
    cloth.widen(arms, "arm", ease, lambda s: np.interp(s, [-0.25, -0.02, 0.10, 0.24], [0.058, 0.054, 0.050, 0.040]))
    cloth.drape(ease)
    return cloth.part("shirt", "shirt-cotton", [_around_body(body), *_tubes(body, arms, "arm", 0.056)])


def trousers_of(body: Body) -> Part:
    hips = body.rig.at("upperleg01.L")[1]
    ankle = body.rig.at("foot.L")[1] + ANKLE

    def is_trousers(centre, leg, arm):
        return (centre[:, 1] < hips + WAIST) & (arm < 0.5) & (centre[:, 1] > ankle)

    legs = [Limb(body.rig, "leg", side) for side in SIDES]
    cloth = _Cloth(body, is_trousers)
    ease = np.full(len(cloth.positions), 0.0055)
    ease += 0.005 * cloth.leg
    cloth.widen(legs, "leg", ease, lambda s: np.interp(s, [-0.30, -0.05, 0.10, 0.40], [0.088, 0.078, 0.078, 0.074]))
    cloth.drape(ease)
    return cloth.part("trousers", "trousers-denim", [_around_body(body, "hips"), *_tubes(body, legs, "leg", 0.088)])


def shoes_of(body: Body) -> Part:
    ankle = body.rig.at("foot.L")[1]
    cloth = _Cloth(body, lambda centre, leg, arm: centre[:, 1] < ankle + SHOE_TOP)
    ease = np.full(len(cloth.positions), 0.007)
    cloth.drape(ease)
    floor = cloth.positions[:, 1].min()
    # The sole is flat.
    cloth.positions[:, 1] = np.maximum(cloth.positions[:, 1], floor + 0.012)
    return cloth.part("shoes", "shoes", None)


class _Cloth:
    """A cut-out of the tights, subdivided once."""

    def __init__(self, body: Body, is_kept, keep=None):
        mesh = body.mesh
        quads = mesh.quads[mesh.groups == "helper-tights"]
        centre = body.base[quads].mean(axis=1)
        leg, arm = (body.side_weight(quads.ravel(), *bones).reshape(-1, 4).mean(axis=1) for bones in (LEGS, ARMS))
        kept = is_kept(centre, leg, arm)
        if keep is not None:
            kept &= keep(centre, arm)
        used, index = np.unique(quads[kept], return_inverse=True)
        matrix, self.quads = catmull_clark(index.reshape(-1, 4), len(used))
        self.positions = matrix @ body.base[used]
        self.weights = matrix @ body.rig.weights[used]
        self.leg, self.arm = (matrix @ body.side_weight(used, *bones) for bones in (LEGS, ARMS))
        skin = np.unique(mesh.quads[mesh.groups == "body"])
        self._skin = body.base[skin]
        number = np.full(len(body.base), -1)
        number[skin] = np.arange(len(skin))
        self._facing = vertex_normals(self._skin, number[mesh.quads[mesh.groups == "body"]])
        self._edges = borders(self.quads)

    def widen(self, limbs, kind: str, ease: np.ndarray, radius) -> None:
        """Widens tubes of cloth to a radius, a function of the distance from the hinge along the limb."""
        on_limb = self.arm if kind == "arm" else self.leg
        for limb, sign in zip(limbs, (1, -1), strict=True):
            _, along, away = limb.measure(self.positions)
            size = np.linalg.norm(away, axis=1)
            t = np.clip((on_limb - 0.55) / 0.4, 0, 1) * (self.positions[:, 0] * sign > 0)
            wanted = np.maximum(size + ease, radius(along))
            self.positions += away * (t * (wanted / np.maximum(size, 1e-6) - 1))[:, None]

    def drape(self, ease: np.ndarray) -> None:
        """Smooths the cloth, and keeps it at a distance from the skin."""
        count = len(self.positions)
        ends = np.concatenate([self.quads, np.roll(self.quads, -1, axis=1)], axis=1).reshape(-1, 2, 4)
        rows, cols = ends[:, 0].ravel(), ends[:, 1].ravel()
        links = coo_matrix((np.ones(2 * len(rows)), (np.r_[rows, cols], np.r_[cols, rows])), (count, count)).tocsr()
        links.data[:] = 1
        rim = np.zeros(count, bool)
        rim[np.concatenate(self._edges)] = True
        # Points of an edge are averaged along the edge, so that hems stay straight.
        links = diags((~rim).astype(float)) @ links
        for loop in self._edges:
            for other in (np.roll(loop, 1), np.roll(loop, -1)):
                links = links + coo_matrix((np.ones(len(loop)), (loop, other)), (count, count)).tocsr()
        mean = diags(1 / np.asarray(links.sum(axis=1)).ravel()) @ links
        tree = cKDTree(self._skin)
        for _ in range(ROUNDS):
            self.positions += 0.5 * (mean @ self.positions - self.positions)
            _, nearest = tree.query(self.positions, k=3)
            out = self._facing[nearest]
            gap = ((self.positions[:, None] - self._skin[nearest]) * out).sum(axis=2)
            push = np.maximum(ease[:, None] - gap, 0).max(axis=1)
            self.positions += out.mean(axis=1) * push[:, None]

    def part(self, name: str, material: str, charts: list[Chart] | None) -> Part:
        """Folds the hems inwards, and unwraps the cloth."""
        positions, quads, weights = self.positions, self.quads, self.weights
        normals = vertex_normals(positions, quads)
        leg, arm, flat = self.leg, self.arm, positions
        outwards = self._outwards()
        for loop in self._edges:
            inner = len(positions) + np.arange(len(loop))
            flat = np.concatenate([flat, positions[loop] + outwards[loop] * HEM])
            positions = np.concatenate([positions, positions[loop] - normals[loop] * HEM])
            hem = np.stack([np.roll(loop, -1), loop, inner, np.roll(inner, -1)], axis=1)
            quads = np.concatenate([quads, hem])
            weights = np.concatenate([weights, weights[loop]])
            leg, arm = np.append(leg, leg[loop]), np.append(arm, arm[loop])
            normals = np.concatenate([normals, normals[loop]])
        positions = np.round(positions, 7)
        normals = vertex_normals(positions, quads)
        if charts is None:
            part = Part(name, material, positions, normals, None, triangulate(quads, positions))
            part.joints, part.weights = strongest(weights)
            return part
        # In the texture, hems extend the cloth.
        uv, corner, vertex = unwrap(flat, quads, charts, {"leg": leg, "arm": arm})
        part = Part(name, material, positions[vertex], normals[vertex], uv, triangulate(corner, positions[vertex]))
        part.joints, part.weights = strongest(weights[vertex])
        return part

    def _outwards(self) -> np.ndarray:
        """Returns, for each point of an edge, the unit direction out of the cloth."""
        centre = self.positions[self.quads].mean(axis=1)
        total = np.zeros_like(self.positions)
        for k in range(4):
            np.add.at(total, self.quads[:, k], self.positions[self.quads[:, k]] - centre)
        return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-9)


LEGS = ("upperleg", "lowerleg", "foot")
ARMS = ("upperarm", "lowerarm", "wrist")


def _before_wrist(arms: list[Limb]):
    def keep(centre, arm):
        ends = [limb.measure(centre)[1] - limb.length[1] for limb in arms]
        at_end = np.where(centre[:, 0] > 0, ends[0], ends[1])
        return (arm < 0.5) | (at_end < -0.012)

    return keep


def _around_body(body: Body, name="torso") -> Chart:
    """The chart around the trunk. Its seam is at the back."""
    z = body.rig.at("spine03")[2]

    def place(points):
        return np.arctan2(points[:, 0], points[:, 2] - z), points[:, 1]

    limb = "arm" if name == "torso" else "leg"
    return Chart(name, place, lambda weights, points: ~_is_on(limb, weights, points, body), 0.165)


def _tubes(body: Body, limbs: list[Limb], kind: str, radius: float) -> list[Chart]:
    return [_tube(body, limb, kind, sign, radius) for limb, sign in zip(limbs, (1, -1), strict=True)]


def _tube(body: Body, limb: Limb, kind: str, sign: int, radius: float) -> Chart:
    def place(points):
        angle, along, _ = limb.measure(points)
        # The seam is on the inner side of the limb.
        turned = angle * sign + (0 if kind == "arm" else 0.5 * np.pi)
        return np.arctan2(np.sin(turned), np.cos(turned)), -along

    return Chart(
        kind, place, lambda weights, points: _is_on(kind, weights, points, body) & (points[:, 0] * sign > 0), radius
    )


def _is_on(kind: str, weights, points, body: Body) -> np.ndarray:
    """Returns which quads belong to the chart of a limb. The crotch belongs to the legs."""
    crotch = body.rig.at("upperleg01.L")[1] - CROTCH
    return (weights[kind] > 0.5) | ((kind == "leg") & (points[:, 1] < crotch))
