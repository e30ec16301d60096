"""Computes scalar fields over a texture: noise, spots, outlines and occlusion. Other modules paint maps with them."""

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import binary_dilation, gaussian_filter, map_coordinates
from scipy.ndimage import label as measure

from ..raster import Atlas
from . import landmarks


class Fields:
    """Creates fields over the skin's texture, as arrays (size, size).

    `space`: position of each texel in the model, metres. `near`: mask of the texels that are on the skin, or up to 8
    texels away from it.
    """

    def __init__(self, atlas: Atlas, positions: np.ndarray, seed: int):
        self.size = atlas.size
        self.space = atlas.spread(positions)
        self.seed = seed
        self.near = binary_dilation(atlas.covered, iterations=8)
        self.spread = atlas.spread

    def noise(self, size: float, channel: int, stretch=(1, 1, 1)) -> np.ndarray:
        """Returns smooth noise with mean 0, a standard deviation of about 1 and spots of `size` metres.

        The noise depends on the position in space, so UV seams are not visible. `channel` selects the random seed.
        """
        lattice = np.random.default_rng([self.seed, channel]).normal(size=(48, 48, 48))
        at = self.space / (size * np.array(stretch)) + 1000.0
        values = map_coordinates(lattice, at.reshape(-1, 3).T, order=1, mode="grid-wrap")
        return (values * 1.7).reshape(self.size, self.size)

    def rough(self, size: float, channel: int) -> np.ndarray:
        """Returns the sum of three octaves of noise. Uses the channels from `channel` to `channel + 2`."""
        return (
            self.noise(size, channel)
            + 0.6 * self.noise(size / 2.1, channel + 1)
            + 0.4 * self.noise(size / 4.3, channel + 2)
        ) / 1.25

    def near_to(self, point: np.ndarray, radius: float) -> np.ndarray:
        """Returns a Gaussian around a point in space: 1 at the point, 1/e at a distance of `radius` metres."""
        return np.exp(-((self.space - point) ** 2).sum(axis=2) / radius**2)


class FaceFields(Fields):
    """Creates fields around the landmarks of a face.

    `canonical`: position of each texel on MakeHuman's base figure, metres. It is the same for all people.
    """

    def __init__(self, atlas: Atlas, canonical: np.ndarray, positions: np.ndarray, seed: int):
        super().__init__(atlas, positions, seed)
        self.canonical = atlas.spread(canonical)
        # The openings of mouth and eyes are connected regions of texels outside all triangles.
        label, _ = measure(~atlas.covered)

        def at(u, v):
            return label == label[int(v * self.size), int(u * self.size)]

        self.mouth_hole = at(*landmarks.MOUTH_OPENING).astype(float)
        u, v = landmarks.EYE_OPENING
        self.eye_holes = (at(u, v) | at(1 - u, v)).astype(float)

    def stripes(self, size: float, channel: int) -> np.ndarray:
        """Returns noise that is stretched vertically, for the creases of lips."""
        return self.noise(size, channel, stretch=(1, 7, 3))

    def spot(self, name: str, radius: float, stretch=(1, 1, 1)) -> np.ndarray:
        """Returns a Gaussian around the landmark `name`, or around both landmarks of a pair.

        Along each axis, it is 1/e at a distance of `radius` metres times the `stretch` of the axis.
        """
        points = (
            [landmarks.MIDDLE[name]]
            if name in landmarks.MIDDLE
            else [landmarks.LEFT[name], (1 - landmarks.LEFT[name][0], landmarks.LEFT[name][1])]
        )
        total = np.zeros((self.size, self.size))
        for u, v in points:
            centre = self.canonical[int(v * self.size), min(int(u * self.size), self.size - 1)]
            total = np.maximum(
                total, np.exp(-(((self.canonical - centre) / np.array(stretch)) ** 2).sum(axis=2) / radius**2)
            )
        return total

    def outline(self, points: list[tuple[float, float]], soft: float, mirror=True) -> np.ndarray:
        """Returns a mask that is 1 inside a closed outline, and inside its mirror image if `mirror` is true.

        `points`: vertices of the outline in uv. `soft`: standard deviation of the Gaussian that blurs the mask's edge,
        in uv.
        """
        scale = 2
        image = Image.new("L", (self.size * scale, self.size * scale), 0)
        draw = ImageDraw.Draw(image)
        draw.polygon([(u * self.size * scale, v * self.size * scale) for u, v in points], fill=255)
        if mirror:
            draw.polygon([((1 - u) * self.size * scale, v * self.size * scale) for u, v in points], fill=255)
        inside = np.asarray(image.reduce(scale), float) / 255
        return gaussian_filter(inside, soft * self.size)


def occlusion(points: np.ndarray, normals: np.ndarray, scene: np.ndarray, directions=128) -> np.ndarray:
    """Returns the ambient occlusion of points (n, 3): the visible fraction of the hemisphere, weighted by the cosine.

    1 means unoccluded. For each direction, computes a shadow map: a grid with the depths of `scene`. `scene` (m, 3) is
    a dense cloud of points on all surfaces.
    """
    cell = 0.9e-3
    seen = np.zeros(len(points))
    weight = np.zeros(len(points))
    for k in range(directions):
        y = 1 - 2 * (k + 0.5) / directions  # Fibonacci sphere
        turn = k * np.pi * (3 - np.sqrt(5))
        towards = np.array([np.sqrt(1 - y * y) * np.cos(turn), y, np.sqrt(1 - y * y) * np.sin(turn)])
        side = np.cross(towards, [0, 0, 1] if abs(towards[2]) < 0.9 else [0, 1, 0])
        side /= np.linalg.norm(side)
        frame = np.stack([side, np.cross(towards, side)], axis=1)
        flat = _dot(scene, frame[:, 0], frame[:, 1])
        low = flat.min(axis=0) - 2 * cell
        grid = tuple((np.ceil((flat.max(axis=0) - low) / cell) + 3).astype(int))
        depth = np.full(grid[0] * grid[1], -np.inf)
        np.maximum.at(depth, _cells(flat, low, cell, grid), _dot(scene, towards)[:, 0])
        cosine = np.clip(_dot(normals, towards)[:, 0], 0, None)
        lifted = points + normals * 1.0e-3
        cells = _cells(_dot(lifted, frame[:, 0], frame[:, 1]), low, cell, grid)
        seen += cosine * (_dot(lifted, towards)[:, 0] > depth[cells] - 1.6e-3)
        weight += cosine
    return seen / weight


def _cells(flat: np.ndarray, low: np.ndarray, cell: float, grid: tuple[int, int]) -> np.ndarray:
    """Returns, for each point (n, 2), the index of its cell in the flattened grid. Clamps points to the grid."""
    index = np.clip(((flat - low) / cell).astype(int), 0, np.array(grid) - 1)
    return np.ravel_multi_index(index.T, grid)


def _dot(points: np.ndarray, *directions: np.ndarray) -> np.ndarray:
    """Returns the dot products of points (n, 3) with directions, (n, number of directions).

    Does not use BLAS, because the last bits of its results depend on the processor.
    """
    return np.stack([points[:, 0] * d[0] + points[:, 1] * d[1] + points[:, 2] * d[2] for d in directions], axis=1)
