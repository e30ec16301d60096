"""Paints the texture of the eyeball: white, veins, iris and pupil.

The image's middle is the front of the eyeball. The distance from the middle is proportional to the angle at the
eyeball's centre.
"""

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import gaussian_filter

from .eyes import REACH


def paint_eye(look: dict, limbus: float, size=512) -> np.ndarray:
    random = np.random.default_rng([look["seed"], 11])
    y, x = np.mgrid[0:size, 0:size]
    x, y = (x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1
    tilt = np.hypot(x, y) * REACH
    turn = np.arctan2(y, x)
    r = tilt / limbus  # 1 at the edge of the iris

    # The white gets redder towards the corners of the eye, and has veins.
    white = np.ones((size, size, 3)) * look["eye_white"]
    red = np.clip((tilt - limbus) / np.radians(55), 0, 1) * np.abs(np.cos(turn)) ** 1.5
    white += (np.array([0.62, 0.36, 0.31]) - white) * (0.60 * red)[..., None]
    veins = Image.new("L", (size * 2, size * 2))
    draw = ImageDraw.Draw(veins)
    for _ in range(46):
        angle = random.choice([0, np.pi]) + random.normal(0, 0.55)
        at = np.array([np.cos(angle), np.sin(angle)]) * random.uniform(0.45, 0.75) * size + size
        heading = angle + np.pi
        for _ in range(random.integers(20, 60)):
            heading += random.normal(0, 0.28)
            ahead = at + 4 * np.array([np.cos(heading), np.sin(heading)])
            if np.hypot(*(ahead - size)) / size * REACH < limbus * 1.12:
                break
            draw.line([tuple(at), tuple(ahead)], fill=int(random.uniform(60, 150)), width=random.integers(1, 3))
            at = ahead
    veins = gaussian_filter(np.asarray(veins.reduce(2), float) / 255, 0.6)
    white += (np.array([0.62, 0.16, 0.12]) - white) * (0.55 * veins)[..., None]

    # The iris has radial fibres, a lighter ring around the pupil, and a dark ring at its edge.
    waves = (
        sum(
            np.sin(turn * n + random.uniform(0, 6.3) + 1.5 * np.sin(3 * r + random.uniform(0, 6.3))) * a
            for n, a in zip(random.integers(18, 140, 16), random.uniform(0.3, 1, 16), strict=True)
        )
        / 4
    )
    blotch = gaussian_filter(random.normal(size=(size, size)), 5) * 8
    iris = np.ones((size, size, 3)) * look["iris"]
    inner = np.exp(-(((r - 0.46) / 0.17) ** 2))[..., None]
    iris += (np.array(look["iris_inner"]) - iris) * 0.75 * inner
    iris *= (1 + 0.20 * waves + 0.07 * blotch)[..., None]
    # The upper lid shades the upper part of the iris.
    iris *= (1.12 - 0.30 * np.clip((-y / (limbus / REACH)) + 0.1, -1, 1) * 0.9)[..., None]
    iris *= (1 - 0.78 * _step(r, 0.80, 1.0))[..., None]
    # The pupil is black.
    iris *= (1 - _step(-r, -0.385, -0.345))[..., None]
    blend = _step(r, 0.93, 1.06)[..., None]
    eye = iris * (1 - blend) + white * blend
    return np.clip(eye, 0, 1)


def _step(value, low, high):
    t = np.clip((value - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
