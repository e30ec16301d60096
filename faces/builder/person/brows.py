"""Draws the hairs of the eyebrows, on the skin and on a transparent shell just above the skin."""

import io

import numpy as np
from PIL import Image, ImageDraw

from ..part import Part
from .landmarks import BROW_BOTTOM, BROW_TOP

# Rectangle of the person's left brow in the skin's texture: u0, v0, u1, v1. The right brow has the mirrored rectangle.
BOX = (0.505, 0.375, 0.68, 0.505)
# Width and height of the drawing of one brow, pixels. The shell's texture shows the right brow beside the left brow,
# both at half this width and height.
SHELL = (1024, 512)
HEIGHT = 0.5e-3  # distance from the skin to the shell, metres


def strokes(look: dict, side: str, seed: int) -> list[np.ndarray]:
    """Returns the hairs of one brow as polylines (5, 2) in the skin's uv."""
    random = np.random.default_rng([seed, side == "left"])
    top, bottom = np.array(BROW_TOP), np.array(BROW_BOTTOM)
    hairs = []
    for _ in range(look["brow_hairs"]):
        # Position of the root along the brow: 0 at its inner end, 1 at its outer end.
        along = 0.93 * random.beta(1.15, 1.3)
        across = random.beta(1.6, 1.5)
        sparse = 0.35 + 0.65 * np.clip(along * 7, 0, 1)
        sparse *= np.interp(along, [0, 0.7, 1], [1, 1, 0.45])
        if random.random() > sparse:
            continue
        low, high = _point_at(bottom, along), _point_at(top, along)
        width = look["brow_width"]
        root = low + (0.5 + (across - 0.5) * width) * (high - low)
        ahead = _point_at(bottom, min(along + 0.05, 1)) + _point_at(top, min(along + 0.05, 1)) - low - high
        ahead /= np.linalg.norm(ahead) + 1e-9
        up = (high - low) / (np.linalg.norm(high - low) + 1e-9)
        # Hairs at the inner end of the brow point up, and those further out point along it. Hairs near the upper edge
        # lean down, and those near the lower edge lean up.
        lean = (
            np.interp(along, [0, 0.15, 0.45, 1], [1.5, 0.9, 0.35, 0.0]) + 0.55 * (0.5 - across) + random.normal(0, 0.16)
        )
        length = (
            look["brow_length"] * random.uniform(0.6, 1.15) * np.interp(along, [0, 0.2, 0.8, 1], [0.8, 1, 0.95, 0.55])
        )
        points = [root]
        for step in range(4):
            turn = lean * (1 - 0.22 * step)
            points.append(points[-1] + (np.cos(turn) * ahead + np.sin(turn) * up) * length / 4)
        line = np.array(points)
        if side == "right":
            line[:, 0] = 1 - line[:, 0]
        hairs.append(line)
    return hairs


def _point_at(line: np.ndarray, t: float) -> np.ndarray:
    """Returns the point (2,) of a polyline (n, 2) at `t`: 0 is the first vertex, 1 the last.

    All segments get equal shares of `t`, even if their lengths differ.
    """
    grid = np.linspace(0, 1, len(line))
    return np.array([np.interp(t, grid, line[:, k]) for k in (0, 1)])


def paint_brows(skin: np.ndarray, look: dict, size: int) -> np.ndarray:
    for side in ("left", "right"):
        cover = _draw(strokes(look, side, look["seed"] + 1), (0, 0, 1, 1), (size * 2, size * 2), 2.2)
        cover = np.asarray(cover.resize((size, size), Image.Resampling.BOX), float)[..., None] / 255
        skin = skin + (np.array(look["brow"]) - skin) * cover * 0.62
    return skin


def shell_map(look: dict) -> tuple[str, bytes]:
    width, height = SHELL
    sheet = Image.new("L", (2 * width, height))
    u0, v0, u1, v1 = BOX
    for side, left in (("right", 0), ("left", width)):
        box = BOX if side == "left" else (1 - u1, v0, 1 - u0, v1)
        drawn = _draw(strokes(look, side, look["seed"] + 2), box, (2 * width, 2 * height), look["brow_thick"])
        sheet.paste(drawn.resize((width, height), Image.Resampling.BOX), (left, 0))
    alpha = np.asarray(sheet.resize((width, height // 2), Image.Resampling.LANCZOS))
    pixels = np.empty((*alpha.shape, 4), np.uint8)
    # Transparent pixels have the hairs' colour too, because texture filtering mixes them in.
    pixels[..., :3] = np.round(np.array(look["brow"]) * 255)
    # Rounds alpha to 31 levels, which compress well.
    pixels[..., 3] = np.round(alpha / 8.5) * 8.5
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "PNG", optimize=True)
    return "image/png", out.getvalue()


def brow_part(skin: Part) -> Part:
    """Builds the shell: a copy of the skin around both brows, lifted by `HEIGHT`.

    The shell keeps only the morph targets that move it by more than 0.3 mm.
    """
    u0, v0, u1, v1 = BOX
    chosen, uv = [], np.zeros_like(skin.uv)
    for side, left in (("right", 0.0), ("left", 0.5)):
        u = skin.uv[:, 0] if side == "left" else 1 - skin.uv[:, 0]
        inside = (u > u0) & (u < u1) & (skin.uv[:, 1] > v0) & (skin.uv[:, 1] < v1)
        t = (u - u0) / (u1 - u0)
        t = t if side == "left" else 1 - t
        uv[inside] = np.stack([left + 0.5 * t, (skin.uv[:, 1] - v0) / (v1 - v0)], axis=1)[inside]
        chosen.append(skin.triangles[inside[skin.triangles].all(axis=1)])
    triangles = np.concatenate(chosen)
    used, index = np.unique(triangles, return_inverse=True)
    lifted = skin.positions[used] + skin.normals[used] * HEIGHT
    targets = {}
    for name, (shift, turn) in skin.targets.items():
        if np.linalg.norm(shift[used], axis=1).max() > 3e-4:
            targets[name] = (shift[used] + turn[used] * HEIGHT, None)
    return Part("brows", "brow", lifted, skin.normals[used], uv[used], index.reshape(-1, 3), targets=targets)


def _draw(hairs, box, pixels, thickness) -> Image.Image:
    """Draws hairs into a gray image. The segments of each hair get thinner towards its tip."""
    u0, v0, u1, v1 = box
    image = Image.new("L", pixels)
    draw = ImageDraw.Draw(image)
    for line in hairs:
        xy = (line - [u0, v0]) / [u1 - u0, v1 - v0] * pixels
        for k in range(len(xy) - 1):
            wide = max(1, round(thickness * (1 - 0.2 * k)))
            draw.line([tuple(xy[k]), tuple(xy[k + 1])], fill=255 if k < 3 else 170, width=wide)
    return image
