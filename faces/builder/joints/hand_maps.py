"""Paints the texture maps of the hand: base colour, normals, and roughness with occlusion. Colours are sRGB, 0..1."""

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import gaussian_filter

from ..person.fields import Fields
from ..person.skin_maps import lay, mottled, relief
from ..raster import Atlas
from .hand import FINGERS, Hand


class HandFields(Fields):
    """Masks of the hand's regions over its texture. Their positions follow from the joints."""

    def __init__(self, hand: Hand, atlas: Atlas, seed: int):
        super().__init__(atlas, hand.part.positions, seed)
        t = np.clip((atlas.spread(hand.inner) + 0.25) / 0.7, 0, 1)
        self.palm = t * t * (3 - 2 * t)
        self.nails = self._filled(hand.nails)
        self.nail_way = atlas.spread(hand.nail_way)
        rig = hand.rig

        def back(name, out):
            return rig.at(name) - rig.frames[rig.names.index(name)][:, 2] * out

        joints = [(f"finger{f}-{k}.L", 0.009 - 0.001 * k) for f in FINGERS for k in (1, 2, 3) if (f, k) != (1, 1)]
        self.knuckles = np.maximum.reduce([self.near_to(back(name, out), 0.0095) for name, out in joints]) * (
            1 - self.palm
        )
        tips = [
            rig.at(f"finger{f}-3.L") + rig.frames[rig.names.index(f"finger{f}-3.L")] @ [0, 0.020, 0.004]
            for f in FINGERS
        ]
        self.tips = np.maximum.reduce([self.near_to(tip, 0.010) for tip in tips])
        self.pads = (
            np.maximum.reduce(
                [
                    *[
                        self.near_to(
                            rig.at(f"finger{f}-1.L")
                            + rig.frames[rig.names.index(f"finger{f}-1.L")] @ [0, 0.002, 0.012],
                            0.011,
                        )
                        for f in FINGERS[1:]
                    ],
                    self.near_to(
                        rig.at("finger1-2.L") + rig.frames[rig.names.index("finger1-2.L")] @ [0, 0, 0.012], 0.018
                    ),
                ]
            )
            * self.palm
        )

    def _filled(self, quads: np.ndarray) -> np.ndarray:
        """Returns a mask that is 1 inside the quads (q, 4, 2) in uv. Its edge is soft and its corners are round."""
        scale = 2
        image = Image.new("L", (self.size * scale, self.size * scale), 0)
        draw = ImageDraw.Draw(image)
        for quad in quads:
            draw.polygon([tuple(point * self.size * scale) for point in quad], fill=255)
        return np.clip(gaussian_filter(np.asarray(image.reduce(scale), float) / 255, 2.4) * 4 - 1.5, 0, 1)


def paint_hand(fields: HandFields, occlusion: np.ndarray, look: dict) -> np.ndarray:
    """Paints the base colour, (size, size, 3): first the skin with blood and freckles, then the nails."""
    rough, noise, palm = fields.rough, fields.noise, fields.palm
    skin = mottled(fields, look)
    skin = lay(skin, np.array(look["palm"]), 0.75 * palm)
    red = (0.55 * fields.knuckles + 0.55 * fields.tips + 0.5 * fields.pads) * (1 + 0.25 * rough(0.004, 21))
    skin = lay(skin, np.array(look["blood"]), np.clip(red, 0, 0.8))
    # Red blotches of the palm.
    skin = lay(skin, np.array(look["blood"]), np.clip(0.14 * palm * np.clip(rough(0.003, 31), 0, 2), 0, 0.4))
    freckles = np.clip(noise(0.0022, 25) - 2.0, 0, 1) + np.clip(noise(0.004, 26) - 2.4, 0, 1)
    skin = lay(skin, np.array(look["freckle"]), np.clip(0.5 * freckles * (1 - palm), 0, 0.5))
    skin *= 1 - 0.5 * look["fold"] * (1 - occlusion)[..., None] * np.array([0.75, 1.0, 1.05])

    way = fields.nail_way
    plate = np.array(look["nail"]) + 0.10 * np.exp(-((way / 0.20) ** 2))[..., None] * [0.3, 0.7, 0.7]
    plate = lay(plate, np.array(look["nail_edge"]), np.clip((way - 0.86) / 0.05, 0, 1))
    rim = np.clip(gaussian_filter(fields.nails, 2.2) * (1 - gaussian_filter(fields.nails, 1.2)) * 4, 0, 1)
    skin = lay(skin, np.array(look["blood"]) * 0.8, 0.45 * rim)
    skin = lay(skin, plate, fields.nails)
    skin[~fields.near] = look["skin"]
    return np.clip(skin, 0, 1)


def paint_hand_relief(fields: HandFields, depth: float) -> np.ndarray:
    """Paints a normal map (size, size, 3), 0..1, of fine furrows. They are weaker on the palm, and nails have none."""
    net = -np.clip(-fields.noise(0.0009, 61) - 0.1, 0, 2) + 0.5 * fields.noise(0.0017, 62)
    height = gaussian_filter(net * (1 - 0.72 * fields.palm), 0.8)
    return relief(height * (1 - np.clip(gaussian_filter(fields.nails, 1.5) * 1.3, 0, 1)), depth, fields.near)


def paint_hand_surface(fields: HandFields, occlusion: np.ndarray, look: dict) -> np.ndarray:
    """Paints the map of occlusion (red), roughness (green) and metalness (blue, 0), packed as in glTF."""
    rough = look["roughness"] + 0.03 * fields.palm + 0.025 * fields.rough(0.004, 71) + 0.03 * fields.noise(0.0008, 74)
    rough = rough * (1 - fields.nails) + 0.34 * fields.nails
    packed = np.stack([occlusion, np.clip(rough, 0.2, 1), np.zeros_like(rough)], axis=2)
    packed[~fields.near] = [1, look["roughness"], 0]
    return packed
