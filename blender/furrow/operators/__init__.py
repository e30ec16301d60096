"""Defines the operators that change the wrinkle set of the active material."""

from . import areas, layers, links, sets

MODULES = (sets, layers, areas, links)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
