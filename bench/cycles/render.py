"""Renders a face in Blender's Cycles. Wrinkles are geometry, and the skin has subsurface scattering.

    python render.py SCENE.json PICTURE.png

The scene file lists the face, the name of the skin's mesh, the camera, lights and blendshape weights. Lengths are in metres, and +Y is up. Binary
files in the same folder contain the displaced skin: positions, texture coordinates, tints of the base colour, and triangles.
"""
import json
import math
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

# Mean free paths of red, green and blue light in pale skin, metres (H. W. Jensen et al., "A Practical Model for Subsurface Light
# Transport", 2001, table 1, skin1).
SCATTERING = (0.00367, 0.00137, 0.00068)
# Fraction of diffuse light that scatters below the surface.
SCATTERED = 0.25


def to_blender(values):
    """Converts glTF's axes to Blender's (+Z up)."""
    x, y, z = np.moveaxis(np.asarray(values, np.float64), -1, 0)
    return np.stack([x, -z, y], -1)


# Name of the vertex colours that multiply the base colour, to show blood in the skin.
TINT = 'tint'


def replace_skin(name, folder):
    positions = to_blender(np.fromfile(folder / 'positions.bin', np.float32).reshape(-1, 3))
    triangles = np.fromfile(folder / 'triangles.bin', np.uint32).reshape(-1, 3).astype(np.int32)
    uvs = np.fromfile(folder / 'uvs.bin', np.float32).reshape(-1, 2)
    old = next(o for o in bpy.data.objects if o.type == 'MESH' and name in (o.name, o.data.name))
    mesh = bpy.data.meshes.new('dense')
    mesh.vertices.add(len(positions))
    mesh.vertices.foreach_set('co', positions.astype(np.float32).ravel())
    mesh.loops.add(triangles.size)
    mesh.loops.foreach_set('vertex_index', triangles.ravel())
    mesh.polygons.add(len(triangles))
    mesh.polygons.foreach_set('loop_start', np.arange(0, triangles.size, 3, dtype=np.int32))
    mesh.polygons.foreach_set('use_smooth', np.ones(len(triangles), bool))
    layer = mesh.uv_layers.new(name=old.data.uv_layers[0].name)
    corners = uvs[triangles.ravel()]
    layer.data.foreach_set('uv', np.stack([corners[:, 0], 1 - corners[:, 1]], -1).astype(np.float32).ravel())
    tints = np.fromfile(folder / 'tints.bin', np.float32).reshape(-1, 3)
    attribute = mesh.color_attributes.new(TINT, 'FLOAT_COLOR', 'POINT')
    attribute.data.foreach_set('color', np.insert(tints, 3, 1, axis=1).ravel())
    mesh.update(calc_edges=True)
    material = old.data.materials[0]
    mesh.materials.append(material)
    skin = bpy.data.objects.new('split skin', mesh)
    bpy.context.scene.collection.objects.link(skin)
    # Duplicate vertices at UV seams are welded, because seams would look like creases.
    weld = skin.modifiers.new('weld', 'WELD')
    weld.merge_threshold = 1e-7
    bpy.data.objects.remove(old)
    return material


def flush(tree, surface):
    colour = surface.inputs['Base Color']
    tint, product = tree.nodes.new('ShaderNodeVertexColor'), tree.nodes.new('ShaderNodeMix')
    tint.layer_name = TINT
    product.data_type, product.blend_type = 'RGBA', 'MULTIPLY'
    factor, first, second = (next(s for s in product.inputs if s.identifier == name) for name in ('Factor_Float', 'A_Color', 'B_Color'))
    factor.default_value = 1
    first.default_value = colour.default_value
    for link in list(colour.links):
        tree.links.new(link.from_socket, first)
    tree.links.new(tint.outputs['Color'], second)
    tree.links.new(next(s for s in product.outputs if s.identifier == 'Result_Color'), colour)


def scatter(material):
    surface = next(node for node in material.node_tree.nodes if node.type == 'BSDF_PRINCIPLED')
    flush(material.node_tree, surface)
    surface.inputs['Subsurface Weight'].default_value = SCATTERED
    surface.inputs['Subsurface Radius'].default_value = SCATTERING
    surface.inputs['Subsurface Scale'].default_value = 1


def aim(target, direction):
    target.rotation_euler = Vector(direction).to_track_quat('-Z', 'Y').to_euler()
    bpy.context.scene.collection.objects.link(target)


def load(description):
    bpy.ops.import_scene.gltf(filepath=description['face'])
    for keys in bpy.data.shape_keys:
        for key in keys.key_blocks:
            key.value = description['targets'].get(key.name, 0)


def light_and_aim(description):
    for lamp in description['lamps']:
        sun = bpy.data.lights.new('lamp', 'SUN')
        sun.energy, sun.angle = lamp['strength'], math.radians(description['lampAngle'])
        aim(bpy.data.objects.new('lamp', sun), -to_blender(lamp['from']))
    camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
    position, target = to_blender(description['camera']['position']), to_blender(description['camera']['target'])
    camera.location = position
    camera.data.angle, camera.data.clip_start = math.radians(description['camera']['fov']), 0.001
    aim(camera, target - position)

    scene = bpy.context.scene
    scene.camera = camera
    scene.world = bpy.data.worlds.new('world')
    scene.world.use_nodes = True
    radiance = description['ambient']
    scene.world.node_tree.nodes['Background'].inputs[0].default_value = (radiance, radiance, radiance, 1)
    scene.view_settings.view_transform = 'Standard'
    scene.render.engine = 'CYCLES'
    scene.render.film_transparent = True
    scene.cycles.samples, scene.cycles.use_denoising = description['samples'], True
    scene.render.resolution_x = scene.render.resolution_y = description['size']
    scene.render.image_settings.color_mode = 'RGBA'


def main():
    scene_path, picture = Path(sys.argv[1]), sys.argv[2]
    description = json.loads(scene_path.read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    load(description)
    scatter(replace_skin(description['skin'], scene_path.parent))
    light_and_aim(description)
    bpy.context.scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


if __name__ == '__main__':
    main()
