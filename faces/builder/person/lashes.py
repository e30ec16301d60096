"""Builds the eyelashes: strips along the lids from MakeHuman's helper meshes, with a transparent texture of hairs."""

import io

import numpy as np
from PIL import Image, ImageDraw

from ..part import Part, triangulate
from ..source import Mesh
from ..subdivide import catmull_clark, vertex_normals
from .head import Head

# Width and height of the texture, pixels. The upper half shows the lashes of the upper lid, the lower half those of the
# lower lid. Their roots are at the bottom of each half.
SIZE = (512, 64)


def lash_part(head: Head, mesh: Mesh, look: dict) -> Part:
    pieces = []
    for side, letter in (("left", "l"), ("right", "r")):
        for row, number in ((0, 2), (1, 1)):
            pieces.append(_strip(head, mesh, f"helper-{letter}-eyelashes-{number}", side, row, look))
    counts = np.cumsum([0] + [len(p[0]) for p in pieces])

    def join(k):
        return np.concatenate([p[k] for p in pieces])

    targets = {}
    for name in sorted({n for p in pieces for n in p[4]}):
        targets[name] = (np.concatenate([p[4].get(name, np.zeros_like(p[0])) for p in pieces]), None)
    triangles = np.concatenate([p[3] + counts[i] for i, p in enumerate(pieces)])
    return Part("lashes", "lash", join(0), join(1), join(2), triangles, targets=targets)


def _strip(head, mesh, group, side, row, look):
    on = mesh.groups == group
    used, quads = np.unique(mesh.quads[on], return_inverse=True)
    quads = quads.reshape(-1, 4)
    uv = np.zeros((len(used), 2))
    uv[quads] = mesh.uv[mesh.uv_quads[on]]
    uv = (uv - uv.min(axis=0)) / (uv.max(axis=0) - uv.min(axis=0))
    matrix, fine = catmull_clark(quads, len(used))
    rim = np.unique(head.fine_quads[head.region == f"socket-{side}"])
    # The roots are on the strip's border that is nearer to the edge of the lid.
    points = head.base[used]
    gap = np.linalg.norm(points[:, None] - head.positions[rim][None], axis=2).min(axis=1)
    if gap[uv[:, 1] > 0.7].mean() < gap[uv[:, 1] < 0.3].mean():
        uv[:, 1] = 1 - uv[:, 1]
    positions, uv = matrix @ points, matrix @ uv
    # Shortens the lashes by moving each vertex towards the nearest root.
    roots = np.flatnonzero(uv[:, 1] < 0.12)
    nearest = roots[np.abs(uv[:, None, 0] - uv[None, roots, 0]).argmin(axis=1)]
    keep = look["lash_length"] * (1.0 if row == 0 else 0.8)

    def mix(values):
        return values[nearest] + (values - values[nearest]) * keep

    positions = mix(positions)
    normals = vertex_normals(positions, fine)
    targets = {}
    for name, unit in head.units.items():
        if np.linalg.norm(unit[used], axis=1).max() > 1e-4:
            targets[name] = mix(matrix @ unit[used])
    flat = np.stack([uv[:, 0], (row + 1 - uv[:, 1]) * 0.5], axis=1)
    return positions, normals, flat, triangulate(fine, positions), targets


def lash_map(look: dict) -> tuple[str, bytes]:
    random = np.random.default_rng([look["seed"], 7])
    width, height = SIZE
    scale = 4
    image = Image.new("L", (width * scale, height * scale))
    draw = ImageDraw.Draw(image)
    for row, (count, reach) in enumerate(((look["lashes"], 0.95), (int(look["lashes"] * 0.6), 0.8))):
        floor = (row + 1) * height * scale / 2
        for _ in range(count):
            x = random.uniform(0.02, 0.98)
            tall = reach * random.uniform(0.55, 1.0) * height * scale / 2 * (0.55 + 0.45 * np.sin(x * np.pi) ** 0.5)
            lean = (x - 0.5) * 0.5 + random.normal(0, 0.12)
            previous = (x * width * scale, floor)
            for k in range(1, 6):
                s = k / 5
                here = (x * width * scale + lean * tall * s * (0.4 + 0.6 * s) * 1.4, floor - tall * s)
                draw.line([previous, here], fill=255, width=max(1, round(7.5 * (1 - 0.8 * s))))
                previous = here
    alpha = np.asarray(image.reduce(scale))
    pixels = np.zeros((height, width, 4), np.uint8)
    pixels[..., :3] = np.round(np.array(look["lash"]) * 255)
    pixels[..., 3] = alpha
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "PNG", optimize=True)
    return "image/png", out.getvalue()
