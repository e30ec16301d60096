"""What Blender is told about when the extension is enabled."""

from . import properties

MODULES = (properties,)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
