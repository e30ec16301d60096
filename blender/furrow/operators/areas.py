"""Operators that add areas, from a vertex group or from an image, and that remove areas."""

import bpy

from ..format.document import MAX_AREAS
from ..format.edit import remove_area
from ..format.reader import FurrowError
from ..paint import image_from_vertex_group
from ..wrinkle_set import rebuild
from .base import WrinkleOperator, active_area, drivers_of, free_name, set_drivers


class FURROW_OT_area_add(WrinkleOperator, bpy.types.Operator):
    """Add an area; choose its image below"""

    bl_idname = "furrow.area_add"
    bl_label = "Area from Image"

    name: bpy.props.StringProperty(name="Name", default="area")

    def run(self, context, tree):
        add_area(tree, self.name, None)


class FURROW_OT_area_from_vertex_group(WrinkleOperator, bpy.types.Operator):
    """Draw the weights of the active vertex group into the area of the same name. Adds the area if it is missing"""

    bl_idname = "furrow.area_from_vertex_group"
    bl_label = "Area from Vertex Group"

    size: bpy.props.IntProperty(name="Size", default=128, min=2, max=8192, description="Width and height in texels")

    def run(self, context, tree):
        face = context.object
        group = face.vertex_groups.active
        if group is None:
            raise FurrowError(f"Furrow: {face.name} has no vertex group; paint weights first")
        image = image_from_vertex_group(face, group, self.size)
        area = tree.furrow.areas.get(group.name)
        if area is None:
            add_area(tree, group.name, image)
        else:
            area.image = image
            area.channel = "0"


class FURROW_OT_area_remove(WrinkleOperator, bpy.types.Operator):
    """Remove the active area and its drivers"""

    bl_idname = "furrow.area_remove"
    bl_label = "Remove Area"

    def run(self, context, tree):
        wrinkles = tree.furrow
        area = active_area(tree)
        set_drivers(tree, remove_area(drivers_of(tree), area.name))
        index = wrinkles.areas.find(area.name)
        # Resting activations are stored by the index of the area, so those of later areas must move.
        rest = [item.activation for item in wrinkles.areas]
        wrinkles.areas.remove(index)
        for item, value in zip(wrinkles.areas, rest[:index] + rest[index + 1 :], strict=True):
            item.activation = value
        wrinkles.active_area = max(0, index - 1)
        rebuild(tree)


def add_area(tree, name, image):
    wrinkles = tree.furrow
    if len(wrinkles.areas) >= MAX_AREAS:
        raise FurrowError(f"Furrow: too many areas, allowed: {MAX_AREAS}; merge areas that move together")
    layer = min(wrinkles.active_layer, max(0, len(wrinkles.layers) - 1))
    area = wrinkles.areas.add()
    area.name = free_name(name, [item for item in wrinkles.areas if item != area])
    area.activation = 0
    area.layer = layer
    area.image = image
    wrinkles.active_area = len(wrinkles.areas) - 1
    return area


CLASSES = (FURROW_OT_area_add, FURROW_OT_area_from_vertex_group, FURROW_OT_area_remove)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
