"""Paints the texture maps of a face, and builds all parts except the skin."""

import numpy as np
from scipy.ndimage import gaussian_filter

from ..part import Part
from ..raster import Atlas
from ..source import Mesh
from .brows import brow_part, shell_map
from .eye_map import paint_eye
from .eyes import ball_of, eye_part, shade_part
from .fields import FaceFields, occlusion
from .head import Head
from .lashes import lash_map, lash_part
from .mouth import mouth_part, socket_part, teeth_part, tongue_part
from .shirt import OVERLAP, shirt_part
from .skin_maps import encode, encode_palette, paint_colour, paint_pores, paint_specular, paint_surface

MAP_SIZE = 1024  # pixels
STEPS = ["occlusion", "colour", "normals", "surface", "parts"]


class Face:
    """Builds a face. Calls `report(step)` at the start of each step, in the order of `STEPS`."""

    def __init__(self, head: Head, mesh: Mesh, skin: Part, vertices: np.ndarray, look: dict, report):
        self._head, self._mesh, self._skin, self._look, self._report = head, mesh, skin, look, report
        canonical = (head.matrix @ mesh.positions[head.used])[vertices]
        atlas = Atlas(skin.uv, skin.triangles, MAP_SIZE)
        fields = FaceFields(atlas, canonical, skin.positions, look["seed"])
        report("occlusion")
        self._eyes = [eye_part(head, mesh, side) for side in ("left", "right")]
        scene = np.concatenate([fields.space[atlas.covered], *[e.positions for e in self._eyes]])
        open_sky = atlas.spread(occlusion(skin.positions, skin.normals, scene))
        # Lightens the upper lid. The lid of an open eye is folded, so its occlusion is dark. On a closed eye, the lid
        # must not be black.
        open_sky += (1 - open_sky) * 0.65 * fields.spot("upper-lid", 0.010, (1.6, 1, 1))
        # Lightens the insides of the lips, which are visible in a smile.
        open_sky += (1 - open_sky) * 0.5 * np.clip(gaussian_filter(fields.mouth_hole, 6) * 2.5, 0, 1)
        report("colour")
        self.colour = paint_colour(fields, open_sky, look)
        report("normals")
        self.pores = paint_pores(fields, look["pores"])
        report("surface")
        self.surface = paint_surface(fields, open_sky, look)
        self.specular = paint_specular(fields, open_sky)

    def images(self) -> dict[str, tuple[str, bytes]]:
        look = self._look
        return {
            "skin-colour": encode(self.colour, "jpeg"),
            "skin-normal": encode_palette(self.pores),
            "skin-surface": encode(self.surface[::2, ::2], "jpeg", 82),
            "skin-specular": encode(self.specular[::4, ::4], "png"),
            "eye": encode(paint_eye(look, ball_of(self._head, self._mesh, "left").limbus), "jpeg", 92),
            "brow": shell_map(look),
            "lash": lash_map(look),
        }

    def parts(self, overlap=OVERLAP) -> list[Part]:
        """Builds all parts except the skin. The last part is the shirt.

        `overlap`: number of rings of quads at the lower end of the neck that the shirt covers.
        """
        head, mesh, look = self._head, self._mesh, self._look
        self._report("parts")
        return [
            *self._eyes,
            shade_part(head, mesh),
            brow_part(self._skin),
            lash_part(head, mesh, look),
            teeth_part(head, mesh, "upper"),
            teeth_part(head, mesh, "lower"),
            tongue_part(head, mesh),
            mouth_part(head),
            socket_part(head),
            shirt_part(head, mesh, overlap),
        ]
