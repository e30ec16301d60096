"""Operators that add an empty wrinkle set, make one automatically, and remove one."""

import bpy

from ..automatic import AutomaticRun, command_path
from ..format.reader import FurrowError
from ..material import detach_group, group_node, insert_group, shader_node, wrinkle_group
from ..preferences import preferred_command
from ..wrinkle_set import load_document, new_group, rebuild
from .base import WrinkleOperator


class FURROW_OT_new_set(bpy.types.Operator):
    """Add a wrinkle set to the active material, driven by the active object's shape keys and bones"""

    bl_idname = "furrow.new_set"
    bl_label = "New Wrinkle Set"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        face = context.object
        return bool(face and face.type == "MESH" and face.active_material and not wrinkle_group(face.active_material))

    def execute(self, context):
        material = context.object.active_material
        try:
            shader_node(material.node_tree)
        except (LookupError, AttributeError):
            self.report({"ERROR"}, f"Furrow: {material.name} has no Principled BSDF, which glTF needs; add one")
            return {"CANCELLED"}
        tree = new_group(f"Wrinkles of {material.name}")
        tree.furrow.face = context.object
        tree.furrow.layers.add().name = "expression"
        rebuild(tree)
        insert_group(material, tree)
        return {"FINISHED"}


class FURROW_OT_remove_set(WrinkleOperator, bpy.types.Operator):
    """Remove the wrinkles of the active material"""

    bl_idname = "furrow.remove_set"
    bl_label = "Remove Wrinkle Set"

    def run(self, context, tree):
        remove_set(context.object.active_material)


class FURROW_OT_make_automatically(bpy.types.Operator):
    """Make wrinkles where the active object's shape keys compress the skin. Esc cancels"""

    bl_idname = "furrow.make_automatically"
    bl_label = "Make Wrinkles Automatically"
    bl_options = {"REGISTER", "UNDO"}

    age: bpy.props.IntProperty(
        name="Age", default=45, min=20, max=80, description="Years. Older faces have more and deeper lines"
    )
    size: bpy.props.EnumProperty(
        name="Size", items=[(s, s, f"{s} texels") for s in ("512", "1024", "2048", "4096")], default="1024"
    )

    @classmethod
    def poll(cls, context):
        face = context.object
        return bool(face and face.type == "MESH" and face.active_material and face.data.shape_keys)

    def start(self, context):
        face = context.object
        command = command_path(preferred_command(context))
        self.face = face
        self.task = AutomaticRun(face, face.active_material, command, ["--age", str(self.age), "--size", self.size])

    def finish(self):
        material = self.task.material
        document, file = self.task.result()
        tree = new_group(f"Wrinkles of {material.name}")
        load_document(tree, document, file.image_of)
        tree.furrow.face = self.face
        if group_node(material):
            remove_set(material)
        rebuild(tree)
        insert_group(material, tree)

    def execute(self, context):
        """Run the command and wait until it is done. Scripts use this method."""
        try:
            self.start(context)
        except FurrowError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return self.end()

    def invoke(self, context, _event):
        """Run the command in the background. The user interface uses this method."""
        try:
            self.start(context)
        except FurrowError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set("Making wrinkles; Esc cancels")
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type != "ESC" and not self.task.poll():
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        if event.type == "ESC":
            self.task.close()
            return {"CANCELLED"}
        return self.end()

    def end(self):
        try:
            self.finish()
        except FurrowError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            self.task.close()
        return {"FINISHED"}


def remove_set(material):
    """Remove the wrinkle group from a material, and delete the group if no other material uses it."""
    node = group_node(material)
    tree = node.node_tree
    detach_group(material)
    material.node_tree.nodes.remove(node)
    if tree.users == 0:
        bpy.data.node_groups.remove(tree)


CLASSES = (FURROW_OT_new_set, FURROW_OT_remove_set, FURROW_OT_make_automatically)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
