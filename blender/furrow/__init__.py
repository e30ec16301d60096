"""Wrinkles for glTF characters in Blender: reads, shows, authors and writes FURROW_wrinkle_maps."""

# Imports nothing of Blender, so that `format` works without it. Blender's glTF importer and exporter look up the two
# functions below in every enabled add-on.


def glTF2ImportUserExtension():
    """Return the hooks for Blender's glTF importer."""
    from .importer import ImportHooks

    return ImportHooks()


def glTF2ExportUserExtension():
    """Return the hooks for Blender's glTF exporter."""
    from .exporter import ExportHooks

    return ExportHooks()


def register():
    from . import registration

    registration.register()


def unregister():
    from . import registration

    registration.unregister()
