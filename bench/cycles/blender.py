"""Draws a face as the extension for Blender imports it, in Cycles.

    python blender.py SCENE.json FOLDER

The scene names the face, weights of shape keys, the camera and the lamps, in the axes of glTF, +Y up, and the activations that three.js
has in the same pose, with which those of Blender's drivers are compared.
"""
import json
import sys
from pathlib import Path

import bpy
import addon_utils
from render import light_and_aim, load

sys.path.insert(0, str(Path(__file__).parents[2] / 'blender'))


def main():
    asked, folder = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable('furrow', default_set=True)
    from furrow.rig import activation_of

    load(asked)
    light_and_aim(asked)
    bpy.context.view_layer.update()
    group = next(tree for tree in bpy.data.node_groups if tree.furrow.is_wrinkles)
    own = {area.name: activation_of(group, i) for i, area in enumerate(group.furrow.areas)}
    worst = max(abs(own[name] - value) for name, value in asked['activations'].items())
    print(f'furrow: activations of {len(own)} areas differ from those of three.js by {worst:.1e} at most')
    bpy.context.scene.render.filepath = str(folder / 'blender.png')
    bpy.ops.render.render(write_still=True)


if __name__ == '__main__':
    main()
