"""Operators that link areas to shape keys, and that remove links and drivers."""

import bpy

from ..format.edit import link_target, remove_link
from ..format.reader import FurrowError
from ..wrinkle_set import rebuild
from .base import WrinkleOperator, active_area, drivers_of, set_drivers


class FURROW_OT_link_shape_key(WrinkleOperator, bpy.types.Operator):
    """Let the active shape key activate the active area"""

    bl_idname = "furrow.link_shape_key"
    bl_label = "Link Active Shape Key"

    target: bpy.props.StringProperty(name="Shape Key", description="If empty, the active shape key")
    weight: bpy.props.FloatProperty(name="Weight", default=1, min=-1000, max=1000, soft_min=-1, soft_max=1)
    start: bpy.props.FloatProperty(
        name="From", default=0, min=-1000, max=1000, description="Shape key value at which the area starts to activate"
    )
    full: bpy.props.FloatProperty(
        name="To", default=1, min=-1000, max=1000, description="Shape key value at which the area is fully active"
    )

    def run(self, context, tree):
        face = tree.furrow.face or context.object
        block = face.active_shape_key
        target = self.target or (block.name if block and face.active_shape_key_index > 0 else "")
        if not target:
            raise FurrowError(f"Furrow: {face.name} has no active shape key; choose one other than the basis")
        if self.full <= self.start:
            raise FurrowError(f"Furrow: To is too small, got {self.full:g}, allowed: above {self.start:g}; increase it")
        numbers = [float(f"{value:.7g}") for value in (self.weight, self.start, self.full)]
        set_drivers(tree, link_target(drivers_of(tree), active_area(tree).name, target, *numbers))
        rebuild(tree)


class FURROW_OT_unlink(WrinkleOperator, bpy.types.Operator):
    """Remove this link"""

    bl_idname = "furrow.unlink"
    bl_label = "Remove Link"

    driver: bpy.props.IntProperty()
    target: bpy.props.StringProperty()

    def run(self, context, tree):
        set_drivers(tree, remove_link(drivers_of(tree), self.driver, self.target))
        rebuild(tree)


class FURROW_OT_driver_remove(WrinkleOperator, bpy.types.Operator):
    """Remove this driver"""

    bl_idname = "furrow.driver_remove"
    bl_label = "Remove Driver"

    driver: bpy.props.IntProperty()

    def run(self, context, tree):
        tree.furrow.drivers.remove(self.driver)
        rebuild(tree)


CLASSES = (FURROW_OT_link_shape_key, FURROW_OT_unlink, FURROW_OT_driver_remove)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
