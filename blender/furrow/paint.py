"""Makes images from a mesh: an area from a vertex group, a normal map from a multires sculpt."""

import bpy
import numpy as np

from .format.reader import FurrowError
from .weights import draw_weights


def image_from_vertex_group(face, group, size):
    """Draw a vertex group's weights into a new gray image, in the mesh's active UV map."""
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
    """Bake a multires sculpt's details over its lowest level into a new normal map."""
    modifier = next((item for item in face.modifiers if item.type == "MULTIRES"), None)
    if modifier is None or modifier.total_levels == 0:
        raise FurrowError(f"Furrow: {face.name} has no subdivided Multires modifier; add one and sculpt")
    image = bpy.data.images.new(f"{face.name} sculpt", size, size, alpha=False)
    image.colorspace_settings.is_data = True
    # Texels outside UV islands stay flat.
    image.generated_color = (0.5, 0.5, 1, 1)
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    active, levels = tree.nodes.active, modifier.levels
    tree.nodes.active = node
    modifier.levels = 0
    render = bpy.context.scene.render
    # Blender 5.0 moved the settings.
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
