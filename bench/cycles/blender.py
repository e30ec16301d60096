"""Renders a face with wrinkles in Cycles, imported by the Blender extension.

    python blender.py SCENE.json FOLDER

The scene file lists the face, shape key weights, the camera and lights in glTF's axes (+Y up). It also lists the activations that three.js computed
in the same pose. The script prints the largest difference between Blender's activations and those of three.js.
"""
import json
import sys
from pathlib import Path

import bpy
import addon_utils
from render import light_and_aim, load

sys.path.insert(0, str(Path(__file__).parents[2] / 'blender'))


def main():
    description, folder = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable('furrow', default_set=True)
    from furrow.rig import activation_of

    load(description)
    light_and_aim(description)
    bpy.context.view_layer.update()
    group = next(tree for tree in bpy.data.node_groups if tree.furrow.is_wrinkles)
    activations = {area.name: activation_of(group, i) for i, area in enumerate(group.furrow.areas)}
    largest = max(abs(activations[name] - value) for name, value in description['activations'].items())
    print(f'furrow: activations of {len(activations)} areas differ from three.js by at most {largest:.1e}')
    bpy.context.scene.render.filepath = str(folder / 'blender.png')
    bpy.ops.render.render(write_still=True)


if __name__ == '__main__':
    main()
