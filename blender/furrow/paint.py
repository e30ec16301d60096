"""Draws the image of an area from a vertex group, and bakes a normal map from a sculpt."""

import bpy
import numpy as np

from .format.reader import FurrowError
from .weights import draw_weights


def image_from_vertex_group(face, group, size):
    """
    Draw the weights of a vertex group into a new gray image, at the UVs of the mesh's active UV map.

    `size`: width and height in texels. Raises FurrowError if the mesh has no UV map.
    """
    mesh = face.data
    layer = mesh.uv_layers.active
    if layer is None:
        raise FurrowError(f"Furrow: {face.name} has no UV map; unwrap it first")
    weights = np.zeros(len(mesh.vertices), np.float32)
    for vertex in mesh.vertices:
        for item in vertex.groups:
            if item.group == group.index:
                weights[vertex.index] = item.weight
    mesh.calc_loop_triangles()
    corners = np.array([triangle.loops for triangle in mesh.loop_triangles]).reshape(-1, 3)
    vertices = np.array([triangle.vertices for triangle in mesh.loop_triangles]).reshape(-1, 3)
    coordinates = np.empty(2 * len(layer.uv), np.float32)
    layer.uv.foreach_get("vector", coordinates)
    drawn = draw_weights(coordinates.reshape(-1, 2)[corners], weights[vertices], size)
    image = bpy.data.images.new(group.name, size, size, alpha=False)
    image.colorspace_settings.is_data = True
    pixels = np.ones((size, size, 4), np.float32)
    pixels[..., :3] = drawn[..., None]
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image


def bake_sculpt(face, material, size):
    """
    Bake a new normal map of the details that are sculpted on a face above level 0 of the face's Multires modifier.

    `size`: width and height in texels. Raises FurrowError without a subdivided Multires modifier, or if the bake fails.
    """
    modifier = next((item for item in face.modifiers if item.type == "MULTIRES"), None)
    if modifier is None or modifier.total_levels == 0:
        raise FurrowError(f"Furrow: {face.name} has no subdivided Multires modifier; add one and sculpt")
    image = bpy.data.images.new(f"{face.name} sculpt", size, size, alpha=False)
    image.colorspace_settings.is_data = True
    # Texels outside UV islands keep the colour of a flat normal map.
    image.generated_color = (0.5, 0.5, 1, 1)
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    active, levels = tree.nodes.active, modifier.levels
    tree.nodes.active = node
    modifier.levels = 0
    render = bpy.context.scene.render
    # Since Blender 5.0, the settings are in `render.bake`.
    owner, multires, kind = (
        (render.bake, "use_multires", "type")
        if hasattr(render.bake, "use_multires")
        else (render, "use_bake_multires", "bake_type")
    )
    before = getattr(owner, multires), getattr(owner, kind)
    try:
        setattr(owner, multires, True)
        setattr(owner, kind, "NORMALS")
        with bpy.context.temp_override(active_object=face, object=face, selected_objects=[face]):
            bpy.ops.object.bake_image()
        image.pack()
    except RuntimeError as error:
        bpy.data.images.remove(image)
        raise FurrowError(f"Furrow: Blender cannot bake {face.name}, {error}") from error
    finally:
        setattr(owner, multires, before[0])
        setattr(owner, kind, before[1])
        modifier.levels = levels
        tree.nodes.remove(node)
        tree.nodes.active = active
    return image
