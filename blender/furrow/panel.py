"""Draws the panel "Wrinkles" in the material properties."""

import json

import bpy

from .format.edit import describe_driver
from .format.plan import UNSUPPORTED
from .material import wrinkle_group
from .rig import activation_of


class FURROW_UL_layers(bpy.types.UIList):
    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _active_property):
        layout.prop(item, "name", text="", emboss=False, icon="RENDERLAYERS")


class FURROW_UL_areas(bpy.types.UIList):
    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _active_property, index):
        layout.prop(item, "name", text="", emboss=False, icon="NONE" if item.image else "ERROR")
        layout.label(text=f"{activation_of(item.id_data, index):.2f}")


class _Panel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return bool(context.object and wrinkle_group(context.object.active_material))


class FURROW_PT_wrinkles(_Panel, bpy.types.Panel):
    bl_label = "Wrinkles"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return bool(context.object and context.object.type == "MESH" and context.object.active_material)

    def draw(self, context):
        layout = self.layout
        tree = wrinkle_group(context.object.active_material)
        if tree is None:
            layout.operator("furrow.new_set", icon="ADD")
        else:
            layout.prop(tree.furrow, "face")
        layout.operator("furrow.make_automatically", icon="SHADERFX")
        if tree is None:
            return
        layout.operator("furrow.remove_set", icon="TRASH")
        for note in tree.furrow.notes.splitlines():
            layout.label(text=note, icon="INFO")


class FURROW_PT_layers(_Panel, bpy.types.Panel):
    bl_label = "Layers"
    bl_parent_id = "FURROW_PT_wrinkles"

    def draw(self, context):
        wrinkles = wrinkle_group(context.object.active_material).furrow
        row = self.layout.row()
        row.template_list("FURROW_UL_layers", "", wrinkles, "layers", wrinkles, "active_layer", rows=2)
        column = row.column(align=True)
        column.operator("furrow.layer_add", icon="ADD", text="")
        column.operator("furrow.layer_remove", icon="REMOVE", text="")
        if wrinkles.active_layer >= len(wrinkles.layers):
            return
        layer = wrinkles.layers[wrinkles.active_layer]
        self.layout.use_property_split = True
        self.layout.prop(layer, "kind")
        for name, number in (
            ("normal", "normal_scale"),
            ("base_color", None),
            ("roughness", None),
            ("occlusion", "occlusion_strength"),
            ("height", "height_amplitude"),
            ("blood", "blood_amplitude"),
            ("onset", "onset_strength"),
        ):
            self.layout.template_ID(
                layer, name, new="image.new", open="image.open", text=name.replace("_", " ").title()
            )
            if number and getattr(layer, name):
                self.layout.prop(layer, number)
        self.layout.operator("furrow.layer_bake", icon="MOD_MULTIRES")


class FURROW_PT_areas(_Panel, bpy.types.Panel):
    bl_label = "Areas"
    bl_parent_id = "FURROW_PT_wrinkles"

    def draw(self, context):
        tree = wrinkle_group(context.object.active_material)
        wrinkles = tree.furrow
        row = self.layout.row()
        row.template_list("FURROW_UL_areas", "", wrinkles, "areas", wrinkles, "active_area", rows=5)
        column = row.column(align=True)
        column.operator("furrow.area_from_vertex_group", icon="GROUP_VERTEX", text="")
        column.operator("furrow.area_add", icon="IMAGE_DATA", text="")
        column.operator("furrow.area_remove", icon="REMOVE", text="")
        if wrinkles.active_area >= len(wrinkles.areas):
            return
        area = wrinkles.areas[wrinkles.active_area]
        self.layout.prop(wrinkles, "preview", toggle=True, icon="HIDE_OFF")
        self.layout.template_ID(area, "image", new="image.new", open="image.open")
        self.layout.use_property_split = True
        self.layout.prop(tree, f'["rest{wrinkles.active_area}"]', text="At Rest")
        for name in ("layer", "channel", "combine"):
            self.layout.prop(area, name)


class FURROW_PT_drivers(_Panel, bpy.types.Panel):
    bl_label = "Drivers"
    bl_parent_id = "FURROW_PT_wrinkles"

    def draw(self, context):
        tree = wrinkle_group(context.object.active_material)
        wrinkles = tree.furrow
        for i, item in enumerate(wrinkles.inputs):
            self.layout.prop(tree, f'["input{i}"]', text=item.name)
        if wrinkles.active_area >= len(wrinkles.areas):
            return
        area = wrinkles.areas[wrinkles.active_area].name
        for i, item in enumerate(wrinkles.drivers):
            driver = json.loads(item.json)
            if driver.get("area") != area:
                continue
            box = self.layout.box()
            row = box.row()
            row.label(text=describe_driver(driver))
            row.operator("furrow.driver_remove", icon="X", text="", emboss=False).driver = i
            if driver["type"] in UNSUPPORTED:
                box.label(text="Exported, but not shown in Blender", icon="INFO")
            for link in driver.get("targets", []) if driver["type"] == "morph" else []:
                row = box.row()
                curve = link.get("curve")
                span = f"  from {curve[0][0]:g} to {curve[-1][0]:g}" if curve else ""
                row.label(text=f"{link['weight']:g} x {link['name']}{span}", icon="SHAPEKEY_DATA")
                unlink = row.operator("furrow.unlink", icon="REMOVE", text="", emboss=False)
                unlink.driver, unlink.target = i, link["name"]
        self.layout.operator("furrow.link_shape_key", icon="LINKED")


CLASSES = (
    FURROW_UL_layers,
    FURROW_UL_areas,
    FURROW_PT_wrinkles,
    FURROW_PT_layers,
    FURROW_PT_areas,
    FURROW_PT_drivers,
)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
