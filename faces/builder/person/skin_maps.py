"""Paints the texture maps of a face's skin: base colour, normals, roughness with occlusion, and specular strength.

Colours are sRGB, 0..1. `look` is an entry of recipes.py.
"""

import io

import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter

from .brows import paint_brows
from .fields import FaceFields, Fields
from .landmarks import BEARD, HAIR, LOWER_LIP, UPPER_LIP
from .skin_net import skin_net


def paint_colour(fields: FaceFields, occlusion: np.ndarray, look: dict) -> np.ndarray:
    """Paints the base colour, (size, size, 3), as layers: skin, blood, spots, folds, lips, beard, hair and brows."""
    spot, rough, noise = fields.spot, fields.rough, fields.noise
    skin = mottled(fields, look)

    # The skin is red where blood is near the surface, and pale on the forehead and the philtrum.
    red = (
        0.75 * spot("cheek", 0.026)
        + 0.5 * spot("cheek-bone", 0.020)
        + 0.8 * spot("nose-tip", 0.014)
        + 0.7 * spot("nose-wing", 0.009)
        + 0.9 * np.maximum.reduce([spot("ear-top", 0.02), spot("ear-middle", 0.022), spot("ear-lobe", 0.016)])
        + 0.35 * spot("chin", 0.018)
        + 0.3 * spot("glabella", 0.014)
        + 0.30 * spot("throat", 0.045)
    ) * (1 + 0.22 * rough(0.005, 21))
    skin = lay(skin, np.array(look["blood"]), np.clip(look["redness"] * red, 0, 0.85))
    pale = 0.35 * spot("forehead", 0.04) + 0.3 * spot("philtrum", 0.012)
    skin = lay(skin, np.array(look["pale"]), 0.4 * pale)

    # The thin skin around the eyes is darker, most of all at the inner corners and below the eyes.
    lids = np.maximum.reduce(
        [
            spot("upper-lid", 0.010, (1.5, 1, 1)),
            0.8 * spot("lower-lid", 0.009, (1.6, 1, 1)),
            0.95 * spot("eye-inner", 0.009),
            0.7 * spot("eye-outer", 0.008),
        ]
    )
    skin = lay(skin, np.array(look["lid"]), np.clip(look["tired"] * lids, 0, 1))
    skin = lay(skin, np.array(look["lid"]), 0.6 * look["tired"] * spot("eye-bag", 0.009, (1.6, 0.8, 1)))
    rim = np.maximum(gaussian_filter(fields.eye_holes, 3), 0) * 1.3
    skin = lay(skin, np.array(look["rim"]), np.clip(rim, 0, 0.9))

    # Sun spots and moles appear where the noise is largest.
    freckles = np.clip(noise(0.0032, 25) - 1.9, 0, 1) + np.clip(noise(0.0055, 26) - 2.3, 0, 1)
    sun = np.clip(0.3 + spot("cheek", 0.05) + spot("forehead", 0.06) + spot("temple", 0.05), 0, 1)
    skin = lay(skin, np.array(look["freckle"]), np.clip(look["freckles"] * freckles * sun, 0, 0.6))

    # Shadows in folds are reddish, because light is reflected several times by the skin.
    dark = (1 - occlusion)[..., None]
    skin *= 1 - look["fold"] * dark * np.array([0.75, 1.0, 1.05])

    # Lips have soft edges and vertical creases. The line between them is darker.
    lips = fields.outline(UPPER_LIP + LOWER_LIP[1:], 0.0028)
    lips = np.clip(lips * (1 + 0.10 * rough(0.004, 29)), 0, 1)
    creases = fields.stripes(0.0011, 33)
    lip = np.array(look["lip"]) * (1 + 0.05 * creases[..., None] + 0.04 * rough(0.002, 30)[..., None])
    skin = lay(skin, lip, look["lips"] * lips)
    line = np.clip(gaussian_filter(fields.mouth_hole, 2) * 1.6, 0, 1)
    skin = lay(skin, np.array(look["lip_line"]), 0.92 * line)

    # Shaved beard and short hair are drawn as a tone with fine specks.
    specks = np.clip(noise(0.00055, 41), -1.4, 1.8)
    if look["beard"]:
        beard = fields.outline(BEARD, 0.010) * (1 - 0.9 * np.clip(lips * 1.5, 0, 1)) * (0.8 + 0.2 * rough(0.012, 45))
        skin = lay(
            skin, np.array(look["beard_colour"]), np.clip(look["beard"] * beard * (0.85 + 0.30 * specks), 0, 0.85)
        )
    hair = fields.outline(HAIR, look["hair_softness"])
    edge = 4 * hair * (1 - hair)  # 1 on the hairline, which noise makes uneven
    ragged = np.clip(hair + (0.10 * rough(0.0022, 49) + 0.14 * noise(0.0007, 54)) * edge, 0, 1)
    strength = ragged**1.4 * (1 - look["thinning"] * spot("hairline", 0.06))
    grey = np.clip(look["grey"] * (0.6 + spot("temple", 0.05) + 0.2 * rough(0.01, 52)) + 0.12 * noise(0.0006, 53), 0, 1)
    tone = np.array(look["hair"]) + (np.array(look["hair_grey"]) - np.array(look["hair"])) * grey[..., None]
    skin = lay(skin, tone, np.clip(look["hair_cover"] * strength * (0.93 + 0.16 * specks), 0, 0.97))

    skin = paint_brows(skin, look, fields.size)
    # Texels far from the skin are never sampled. They get a constant colour, which compresses well.
    skin[~fields.near] = look["skin"]
    return np.clip(skin, 0, 1)


def mottled(fields: Fields, look: dict) -> np.ndarray:
    """Paints the colour of skin without features. Blood and pigment vary at three scales."""
    rough, noise = fields.rough, fields.noise
    skin = np.broadcast_to(np.array(look["skin"]), (fields.size, fields.size, 3)).copy()
    blood = 0.5 * rough(0.020, 1) + 0.5 * rough(0.006, 5)
    pigment = 0.6 * rough(0.014, 9) + 0.5 * rough(0.0035, 13)
    skin *= 1 + look["mottle"] * (blood[..., None] * [0.2, -0.7, -0.6] + pigment[..., None] * [-0.5, -0.7, -1.0])
    return skin * (1 + 0.018 * noise(0.0007, 17)[..., None] + 0.016 * noise(0.0013, 18)[..., None])


def paint_pores(fields: FaceFields, depth: float) -> np.ndarray:
    """Paints a tangent-space normal map (size, size, 3), 0..1, of the skin at rest: furrows, pores, creases of lips."""
    spot = fields.spot
    lids = np.maximum(spot("upper-lid", 0.011, (1.5, 1, 1)), spot("lower-lid", 0.009, (1.5, 1, 1)))
    ears = np.maximum.reduce([spot("ear-top", 0.02), spot("ear-middle", 0.022), spot("ear-lobe", 0.016)])
    nose = np.maximum.reduce([spot("nose-tip", 0.016), spot("nose-wing", 0.011), 0.6 * spot("nose-bridge", 0.014)])
    cheek = np.maximum(spot("cheek", 0.024), 0.8 * spot("cheek-bone", 0.018))
    chin = spot("chin", 0.018)
    forehead = np.maximum(spot("forehead", 0.045), spot("glabella", 0.018))
    temple = np.maximum(spot("temple", 0.026), 0.7 * spot("jaw", 0.03))

    # Distance between the plateaus of `skin_net`, metres: larger on cheeks and neck, smaller on the forehead and lids.
    spacing = 0.0013 + 0.0001 * cheek + 0.0002 * spot("throat", 0.05) - 0.0003 * forehead - 0.0004 * lids
    furrow, pore = skin_net(fields, spacing, width=0.55)
    # The depth of furrows and pores varies within a centimetre, as in real skin.
    patchy = np.clip(1 + 0.3 * fields.rough(0.009, 61), 0.3, 1.6)
    furrows = 0.28 + 0.15 * forehead + 0.1 * chin - 0.12 * cheek - 0.2 * temple - 0.12 * lids
    pores = 0.16 + 0.75 * nose + 0.5 * cheek + 0.3 * chin - 0.1 * forehead - 0.12 * temple
    bare = (1 - 0.75 * lids) * (1 - 0.6 * ears)
    bare *= 1 - np.clip(fields.outline(HAIR, 0.008) * 1.2, 0, 1)
    sunk = np.maximum(furrows, 0) * furrow + np.maximum(pores, 0) * pore
    height = gaussian_filter(-sunk * patchy * bare, 0.6)
    lips = fields.outline(UPPER_LIP + LOWER_LIP[1:], 0.002)
    height = height * (1 - lips) + 0.65 * gaussian_filter(fields.stripes(0.0011, 33), 1.0) * lips
    return relief(height, depth, fields.near, step=4)


def relief(height: np.ndarray, depth: float, near: np.ndarray, step=3) -> np.ndarray:
    """Converts heights to a tangent-space normal map (size, size, 3), 0..1, with x right and y up.

    `height` times `depth` is the height in texels. The map is flat where `near` is false. The bytes of x and y are 128
    plus a multiple of `step`. Larger steps compress better: a step of 3 instead of 1 shrinks the file by 60 per cent,
    and pores still look smooth.
    """
    right, down = np.gradient(height, axis=1), np.gradient(height, axis=0)
    normal = np.stack([-depth * right, depth * down, np.ones_like(height)], axis=2)
    normal[~near] = [0, 0, 1]
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    steps = np.round(normal[..., :2] * 127 / step) * step
    flat = np.concatenate([steps, np.full((*steps.shape[:2], 1), 127.0)], axis=2)
    return (flat + 128) / 255


def paint_surface(fields: FaceFields, occlusion: np.ndarray, look: dict) -> np.ndarray:
    """Paints the map of occlusion (red), roughness (green) and metalness (blue, 0), packed as in glTF."""
    spot = fields.spot
    oily = np.clip(
        0.9 * spot("nose-tip", 0.018)
        + 0.6 * spot("forehead", 0.038)
        + 0.5 * spot("nose-bridge", 0.018)
        + 0.35 * spot("chin", 0.014)
        + 0.4 * spot("cheek-bone", 0.018),
        0,
        1,
    )
    rough = look["roughness"] - 0.07 * oily + 0.025 * fields.rough(0.004, 71) + 0.03 * fields.noise(0.0008, 74)
    lips = fields.outline(UPPER_LIP + LOWER_LIP[1:], 0.003)
    rough = rough * (1 - lips) + 0.40 * lips
    hair = fields.outline(HAIR, 0.008)
    rough = rough + 0.12 * hair
    # The line between the lips has no highlight.
    rough = np.maximum(rough, 0.9 * np.clip(gaussian_filter(fields.mouth_hole, 3) * 2, 0, 1))
    wet = np.clip(gaussian_filter(fields.eye_holes, 2) * 1.5, 0, 1)
    rough = rough * (1 - wet) + 0.28 * wet
    packed = np.stack([occlusion, np.clip(rough, 0.2, 1), np.zeros_like(rough)], axis=2)
    packed[~fields.near] = [1, look["roughness"], 0]
    return packed


def paint_specular(fields: FaceFields, occlusion: np.ndarray) -> np.ndarray:
    """Paints the strength of highlights in alpha. It is low where the face itself blocks the light.

    A renderer's shadow maps rarely have enough texels to prevent highlights between the lips.
    """
    line = np.clip(gaussian_filter(fields.mouth_hole, 4) * 2.5, 0, 1)
    amount = np.clip(gaussian_filter(occlusion, 2) * 1.6 - 0.3, 0, 1) * (1 - line)
    amount[~fields.near] = 1
    return np.concatenate([np.ones((*amount.shape, 3)), amount[..., None]], axis=2)


def encode(image: np.ndarray, kind: str, quality=88) -> tuple[str, bytes]:
    data = Image.fromarray(np.round(np.clip(image, 0, 1) * 255).astype(np.uint8))
    out = io.BytesIO()
    if kind == "png":
        data.save(out, "PNG", optimize=True)
    else:
        data.save(out, "JPEG", quality=quality, subsampling=2, optimize=True)
    return f"image/{kind}", out.getvalue()


def encode_palette(image: np.ndarray) -> tuple[str, bytes]:
    """Encodes a PNG with a palette of the 256 most frequent colours.

    For normal maps of skin, the file is 30 per cent smaller than without a palette. Other colours, which occur in the
    steepest creases of the lips, are replaced by the nearest colour of the palette.
    """
    pixels = np.round(np.clip(image, 0, 1) * 255).astype(np.uint8)
    colours, texels, counts = np.unique(pixels.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    kept = colours[np.sort(np.argsort(-counts, kind="stable")[:256])]
    nearest = np.square(colours[:, None].astype(int) - kept[None].astype(int)).sum(axis=2).argmin(axis=1)
    data = Image.fromarray(nearest[texels].astype(np.uint8).reshape(pixels.shape[:2]), "P")
    data.putpalette(kept.tobytes())
    out = io.BytesIO()
    # Compression type 1 is zlib's strategy Z_FILTERED, which suits noise.
    data.save(out, "PNG", compress_level=9, compress_type=1)
    return "image/png", out.getvalue()


def lay(under: np.ndarray, colour: np.ndarray, amount: np.ndarray) -> np.ndarray:
    return under + (colour - under) * np.clip(amount, 0, 1)[..., None]
