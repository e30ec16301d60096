"""Wrinkles for glTF characters in Blender: reads, shows, authors and writes FURROW_wrinkle_maps."""

# Nothing of Blender is imported here, so that `format` can be used and tested without it. Blender's glTF importer and
# exporter look for these two names in every add-on that is enabled.


def glTF2ImportUserExtension():
    """Called by Blender's glTF importer."""
    from .importer import ImportHooks

    return ImportHooks()


def glTF2ExportUserExtension():
    """Called by Blender's glTF exporter."""
    from .exporter import ExportHooks

    return ExportHooks()


def register():
    from . import registration

    registration.register()


def unregister():
    from . import registration

    registration.unregister()
