"""Blender extension that imports, shows, edits and exports the wrinkles of glTF characters (FURROW_wrinkle_maps)."""

# This module does not import bpy, so that `format` can be imported without Blender. Blender's glTF importer and
# exporter look up the next two functions by name in every enabled add-on.


def glTF2ImportUserExtension():
    from .importer import ImportHooks

    return ImportHooks()


def glTF2ExportUserExtension():
    from .exporter import ExportHooks

    return ExportHooks()


def register():
    from . import registration

    registration.register()


def unregister():
    from . import registration

    registration.unregister()
