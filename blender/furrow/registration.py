"""Registers the classes and handlers of the extension in Blender."""

from . import delays, operators, panel, preferences, properties
from .exporter import restore_materials

MODULES = (properties, preferences, operators, panel, delays)


def register():
    for module in MODULES:
        module.register()


def unregister():
    restore_materials()
    for module in reversed(MODULES):
        module.unregister()
