"""Computes the fine relief of skin: a net of furrows between small plateaus, with pores where furrows meet.

The plateaus are the cells of a cellular texture (S. Worley, "A Cellular Texture Basis Function", 1996). Its points lie
on the surface, so UV seams are not visible and sizes are in metres.
"""

import numpy as np
from scipy.spatial import cKDTree

from .fields import Fields


def skin_net(fields: Fields, spacing: np.ndarray, width: float) -> tuple[np.ndarray, np.ndarray]:
    """Returns two maps, the depth of furrows and the depth of pores: 0 on a plateau, 1 at the deepest point.

    `spacing`: distance between plateaus at each texel, metres. `width`: width of furrows, as a fraction of the spacing.
    """
    points = scattered(fields, spacing)
    tree = cKDTree(points)
    texels = fields.space[fields.near]
    distances, _ = tree.query(texels, k=3)
    size = spacing[fields.near] * width
    furrows, pores = np.zeros(spacing.shape), np.zeros(spacing.shape)
    furrows[fields.near] = 1 - smooth((distances[:, 1] - distances[:, 0]) / size)
    pores[fields.near] = 1 - smooth((distances[:, 2] - distances[:, 0]) / size)
    return furrows, pores


def scattered(fields: Fields, spacing: np.ndarray) -> np.ndarray:
    """Scatters points (n, 3) on the skin with a minimum distance and few gaps (Poisson disk sampling)."""
    random = np.random.default_rng([fields.seed, 71])
    inside = np.flatnonzero(fields.near)
    texel = area_of_texels(fields.space).ravel()[inside]
    reach = spacing.ravel()[inside]
    # With four random candidates per square of side `spacing`, few gaps remain.
    expected = texel / reach**2
    count = int(4 * expected.sum())
    chosen = random.choice(len(inside), size=count, p=expected / expected.sum())
    points = fields.space.reshape(-1, 3)[inside][chosen]
    # Moves the points randomly, because several points of one texel would coincide.
    points = points + random.uniform(-0.5, 0.5, (count, 3)) * np.sqrt(texel[chosen])[:, None]
    radii = 0.8 * reach[chosen]
    kept = np.zeros(count, bool)
    open_ = np.ones(count, bool)
    near = cKDTree(points).query_pairs(radii.max(), output_type="ndarray")
    gap = np.linalg.norm(points[near[:, 0]] - points[near[:, 1]], axis=1)
    near = near[gap < np.minimum(radii[near[:, 0]], radii[near[:, 1]])]
    # If several points are too close to each other, only the first is kept. Their order is random.
    while open_.any():
        rival = near[open_[near].all(axis=1)]
        beaten = np.zeros(count, bool)
        beaten[rival[:, 1]] = True
        winners = open_ & ~beaten
        kept |= winners
        open_ &= ~winners
        taken = near[winners[near].any(axis=1)].ravel()
        open_[taken] = False
    return points[kept]


def area_of_texels(space: np.ndarray) -> np.ndarray:
    """Returns the area of skin that each texel covers, square metres."""
    right, down = np.gradient(space, axis=1), np.gradient(space, axis=0)
    return np.linalg.norm(np.cross(right, down), axis=2)


def smooth(x: np.ndarray) -> np.ndarray:
    x = np.clip(x, 0, 1)
    return x * x * (3 - 2 * x)
