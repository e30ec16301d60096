"""What activates an area: links to shape keys, and whatever drivers a file brought."""

import bpy

from ..format.edit import link_target, without_link
from ..format.reader import FurrowError
from ..wrinkle_set import rebuild
from .base import OnWrinkles, active_area, drivers_of, set_drivers


class FURROW_OT_link_shape_key(OnWrinkles, bpy.types.Operator):
    """Let the active shape key activate the chosen area"""

    bl_idname = "furrow.link_shape_key"
    bl_label = "Link Active Shape Key"

    target: bpy.props.StringProperty(name="Shape Key", description="Empty for the active one")
    weight: bpy.props.FloatProperty(name="Weight", default=1, min=-1000, max=1000, soft_min=-1, soft_max=1)
    start: bpy.props.FloatProperty(
        name="From", default=0, min=-1000, max=1000, description="Value of the shape key at which it begins"
    )
    full: bpy.props.FloatProperty(
        name="To", default=1, min=-1000, max=1000, description="Value at which it is complete"
    )

    def run(self, context, tree):
        face = tree.furrow.face or context.object
        block = face.active_shape_key
        target = self.target or (block.name if block and face.active_shape_key_index > 0 else "")
        if not target:
            raise FurrowError(f"Furrow: {face.name} has no active shape key; choose one beside the basis")
        if self.full <= self.start:
            raise FurrowError(f"Furrow: To is {self.full:g}, allowed is more than {self.start:g}; choose a larger one")
        numbers = [float(f"{value:.7g}") for value in (self.weight, self.start, self.full)]
        set_drivers(tree, link_target(drivers_of(tree), active_area(tree).name, target, *numbers))
        rebuild(tree)


class FURROW_OT_unlink(OnWrinkles, bpy.types.Operator):
    """Remove this link"""

    bl_idname = "furrow.unlink"
    bl_label = "Remove Link"

    driver: bpy.props.IntProperty()
    target: bpy.props.StringProperty()

    def run(self, context, tree):
        set_drivers(tree, without_link(drivers_of(tree), self.driver, self.target))
        rebuild(tree)


class FURROW_OT_driver_remove(OnWrinkles, bpy.types.Operator):
    """Remove this driver"""

    bl_idname = "furrow.driver_remove"
    bl_label = "Remove Driver"

    driver: bpy.props.IntProperty()

    def run(self, context, tree):
        tree.furrow.drivers.remove(self.driver)
        rebuild(tree)


CLASSES = (FURROW_OT_link_shape_key, FURROW_OT_unlink, FURROW_OT_driver_remove)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
