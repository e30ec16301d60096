"""Draws a face as the extension for Blender imports it, in Cycles.

    python blender.py SCENE.json FOLDER

The scene names the face, weights of shape keys, the camera and the lamps, in the axes of glTF, +Y up, and the activations that three.js
has in the same pose, with which those of Blender's drivers are compared.
"""
import json
import math
import sys
from pathlib import Path

import bpy
import addon_utils
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parents[2] / 'blender'))


def upright(values):
    x, y, z = values
    return Vector((x, -z, y))


def aim(thing, direction):
    thing.rotation_euler = direction.to_track_quat('-Z', 'Y').to_euler()
    bpy.context.scene.collection.objects.link(thing)


def main():
    asked, folder = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable('furrow', default_set=True)
    bpy.ops.import_scene.gltf(filepath=asked['face'])
    for keys in bpy.data.shape_keys:
        for key in keys.key_blocks:
            key.value = asked['targets'].get(key.name, 0)
    for lamp in asked['lamps']:
        sun = bpy.data.lights.new('lamp', 'SUN')
        sun.energy, sun.angle = lamp['strength'], math.radians(4)
        aim(bpy.data.objects.new('lamp', sun), -upright(lamp['from']))
    camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
    camera.location = upright(asked['camera']['position'])
    camera.data.angle, camera.data.clip_start = math.radians(asked['camera']['fov']), 0.001
    aim(camera, upright(asked['camera']['target']) - camera.location)

    scene = bpy.context.scene
    scene.camera = camera
    scene.world = bpy.data.worlds.new('world')
    scene.world.use_nodes = True
    grey = asked['surroundings']
    scene.world.node_tree.nodes['Background'].inputs[0].default_value = (grey, grey, grey, 1)
    scene.view_settings.view_transform = 'Standard'
    scene.render.engine = 'CYCLES'
    scene.render.film_transparent = True
    scene.cycles.samples, scene.cycles.use_denoising = asked['samples'], True
    scene.render.resolution_x = scene.render.resolution_y = asked['size']
    scene.render.image_settings.color_mode = 'RGBA'
    bpy.context.view_layer.update()

    group = next(tree for tree in bpy.data.node_groups if tree.furrow.is_wrinkles)
    own = {area.name: group[f'a{i}'] for i, area in enumerate(group.furrow.areas)}
    worst = max(abs(own[name] - value) for name, value in asked['activations'].items())
    print(f'furrow: activations of {len(own)} areas differ from those of three.js by {worst:.1e} at most')
    scene.render.filepath = str(folder / 'blender.png')
    bpy.ops.render.render(write_still=True)


if __name__ == '__main__':
    main()
