"""Draws vertex weights into an image in UV space. Needs only NumPy, which ships with Blender."""

import numpy as np

#: Width in texels of the margin around UV islands. Without a margin, bilinear filtering mixes in the black background.
MARGIN = 4


def draw_weights(coordinates, weights, size, margin=MARGIN):
    """
    Draw triangles into an image, with interpolated weights.

    `coordinates`: UVs of the corners, v upwards, shape (triangles, 3, 2). `weights`: weights of the corners, 0 to 1,
    shape (triangles, 3). Returns float32 of shape (size, size), bottom row first, as Blender stores images.
    """
    image = np.zeros((size, size), np.float32)
    covered = np.zeros((size, size), bool)
    texels = np.asarray(coordinates, np.float64) * size - 0.5
    # Textures repeat, so triangles outside the image are moved into it by whole image widths and heights.
    texels -= np.floor((texels.mean(axis=1, keepdims=True) + 0.5) / size) * size
    for corners, values in zip(texels, np.asarray(weights, np.float64), strict=True):
        _draw(image, covered, corners, values)
    return _with_margin(image, covered, margin)


def _draw(image, covered, corners, values):
    low = np.maximum(np.ceil(corners.min(axis=0) - 1e-9), 0).astype(int)
    high = np.minimum(np.floor(corners.max(axis=0) + 1e-9), image.shape[0] - 1).astype(int)
    if (low > high).any():
        return
    a, b, c = corners
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if abs(area) < 1e-12:
        return
    x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
    second = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
    third = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
    inside = (second >= -1e-9) & (third >= -1e-9) & (second + third <= 1 + 1e-9)
    interpolated = (1 - second - third) * values[0] + second * values[1] + third * values[2]
    part = np.s_[low[1] : high[1] + 1, low[0] : high[0] + 1]
    image[part][inside] = interpolated[inside]
    covered[part][inside] = True


def _with_margin(image, covered, margin):
    """Extend the covered region by one texel, `margin` times. A new texel is the mean of its covered neighbours."""
    for _ in range(margin):
        total, count = np.zeros_like(image), np.zeros_like(image)
        for dy in (-1, 0, 1):
            for dx in (-1, 0, 1):
                neighbours = _shifted(covered, dy, dx)
                total += np.where(neighbours, _shifted(image, dy, dx), 0)
                count += neighbours
        new = ~covered & (count > 0)
        image[new] = total[new] / count[new]
        covered |= new
    return image


def _shifted(array, dy, dx):
    """Shift an image by `dy` and `dx` texels, each -1 to 1. The uncovered border becomes zero."""
    out = np.zeros_like(array)
    height, width = array.shape
    target = np.s_[max(dy, 0) : height + min(dy, 0), max(dx, 0) : width + min(dx, 0)]
    source = np.s_[max(-dy, 0) : height + min(-dy, 0), max(-dx, 0) : width + min(-dx, 0)]
    out[target] = array[source]
    return out
