"""
Hooks for Blender's glTF exporter.

Blender writes the plain face; then the hooks add the wrinkles to the file. Adding images during the export does not
work: depending on version and options, the exporter merges, reencodes or drops them. During the export, wrinkle groups
are detached, so that Blender finds the plain face's textures.
"""

import bpy

from .format.container import add_wrinkles
from .format.reader import FurrowError
from .material import detach_group, group_node, reattach_group
from .wrinkle_set import document_of


class ExportHooks:
    """State of one export; Blender calls the methods."""

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
        # Restores materials after a failed export, for which Blender calls no hook.
        bpy.app.timers.register(restore_materials, first_interval=0)

    def post_export_hook(self, export_settings):
        restore_materials()
        if self.wrinkles:
            add_wrinkles(export_settings["gltf_filepath"], self.wrinkles)


def restore_materials():
    """Reattach all groups that an export detached."""
    for material in bpy.data.materials:
        reattach_group(material)
    if bpy.app.timers.is_registered(restore_materials):
        bpy.app.timers.unregister(restore_materials)
