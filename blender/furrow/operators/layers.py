"""Operators that add and remove layers, and that bake a sculpt into a layer."""

import bpy

from ..format.document import MAX_LAYERS
from ..format.reader import FurrowError
from ..paint import bake_sculpt
from ..wrinkle_set import rebuild
from .base import WrinkleOperator, free_name


class FURROW_OT_layer_add(WrinkleOperator, bpy.types.Operator):
    """Add a layer; choose its normal map below"""

    bl_idname = "furrow.layer_add"
    bl_label = "Add Layer"

    def run(self, context, tree):
        add_layer(tree, "layer")


class FURROW_OT_layer_remove(WrinkleOperator, bpy.types.Operator):
    """Remove the active layer. Its areas move to the first layer"""

    bl_idname = "furrow.layer_remove"
    bl_label = "Remove Layer"

    def run(self, context, tree):
        wrinkles = tree.furrow
        if len(wrinkles.layers) < 2:
            raise FurrowError("Furrow: a wrinkle set needs at least one layer; remove the set instead")
        index = min(wrinkles.active_layer, len(wrinkles.layers) - 1)
        wrinkles.layers.remove(index)
        for area in wrinkles.areas:
            if area.layer >= index:
                area.layer = 0 if area.layer == index else area.layer - 1
        wrinkles.active_layer = max(0, index - 1)
        rebuild(tree)


class FURROW_OT_layer_bake(WrinkleOperator, bpy.types.Operator):
    """Bake the Multires modifier's details into the normal map of the active layer"""

    bl_idname = "furrow.layer_bake"
    bl_label = "Bake Multires Sculpt"

    size: bpy.props.IntProperty(name="Size", default=1024, min=16, max=8192, description="Width and height in texels")

    def run(self, context, tree):
        wrinkles = tree.furrow
        image = bake_sculpt(context.object, context.object.active_material, self.size)
        layer = wrinkles.layers[wrinkles.active_layer] if wrinkles.layers else add_layer(tree, "sculpt")
        # The baked map shows only details of the sculpt, so it must be added to the material's normal map.
        layer.kind = "detail"
        layer.normal = image


def add_layer(tree, name):
    wrinkles = tree.furrow
    if len(wrinkles.layers) >= MAX_LAYERS:
        raise FurrowError(f"Furrow: too many layers, allowed: {MAX_LAYERS}; put areas on an existing layer")
    layer = wrinkles.layers.add()
    layer.name = free_name(name, [item for item in wrinkles.layers if item != layer])
    wrinkles.active_layer = len(wrinkles.layers) - 1
    return layer


CLASSES = (FURROW_OT_layer_add, FURROW_OT_layer_remove, FURROW_OT_layer_bake)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
