"""
Adds wrinkles to files that Blender's glTF exporter writes.

Before the export, the wrinkle node groups are detached from their materials, so that Blender finds and exports the
materials' textures. After the export, the wrinkles are added to the file. Images cannot be added during the export,
because the exporter may merge, reencode or drop them, depending on its version and options.
"""

import bpy

from .format.container import add_wrinkles
from .format.reader import FurrowError
from .material import detach_group, group_node, reattach_group
from .wrinkle_set import document_of


class ExportHooks:
    """Hooks of one export. Blender calls the methods."""

    def __init__(self):
        self.wrinkles = {}

    def pre_export_hook(self, export_settings):
        for material in bpy.data.materials:
            node = group_node(material)
            if node is None or node.mute:
                continue
            try:
                self.wrinkles[material.name] = document_of(node.node_tree)
            except FurrowError as error:
                text = f"{error}; {material.name} is exported without wrinkles"
                export_settings["log"].warning(text, popup=True)
            detach_group(material)
        # If the export fails, Blender calls no hook. The timer restores the materials then.
        bpy.app.timers.register(restore_materials, first_interval=0)

    def post_export_hook(self, export_settings):
        restore_materials()
        if self.wrinkles:
            add_wrinkles(export_settings["gltf_filepath"], self.wrinkles)


def restore_materials():
    """Reattach all wrinkle groups that an export has detached."""
    for material in bpy.data.materials:
        reattach_group(material)
    if bpy.app.timers.is_registered(restore_materials):
        bpy.app.timers.unregister(restore_materials)
