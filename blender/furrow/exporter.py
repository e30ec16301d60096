"""
Export: hooks of Blender's own glTF exporter.

Blender writes the plain face, the wrinkles are added to the file that it wrote. Images that a hook adds while Blender
gathers are merged, encoded again or dropped by the exporter, depending on its version and its options; a finished file
is the same for all of them, and keeps the bytes of images that nobody painted on. While Blender exports, the groups are
out of their materials, so that it finds the textures of the plain face.
"""

import bpy

from .format.container import add_wrinkles
from .format.reader import FurrowError
from .material import group_node, put_back, take_out
from .wrinkle_set import document_of


class ExportHooks:
    """One per export; Blender calls its methods."""

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
            take_out(material)
        # An export that fails halfway calls no hook.
        bpy.app.timers.register(restore_materials, first_interval=0)

    def post_export_hook(self, export_settings):
        restore_materials()
        if self.wrinkles:
            add_wrinkles(export_settings["gltf_filepath"], self.wrinkles)


def restore_materials():
    """Put all groups back that an export took out."""
    for material in bpy.data.materials:
        put_back(material)
    if bpy.app.timers.is_registered(restore_materials):
        bpy.app.timers.unregister(restore_materials)
