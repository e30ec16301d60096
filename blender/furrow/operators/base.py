"""Code that the operators share."""

import json

from ..format.reader import FurrowError
from ..material import wrinkle_group


class WrinkleOperator:
    """
    Base class of operators that change the wrinkle set of the active material.

    Subclasses implement `run(context, tree)`, where `tree` is the wrinkle group. If `run` raises FurrowError or
    LookupError, Blender shows the message.
    """

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return bool(context.object and wrinkle_group(context.object.active_material))

    def execute(self, context):
        try:
            self.run(context, wrinkle_group(context.object.active_material))
        except (FurrowError, LookupError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def active_area(tree):
    """Return the active area. Raises FurrowError if there are no areas."""
    areas = tree.furrow.areas
    if not areas:
        raise FurrowError("Furrow: missing area, got none; add one first")
    return areas[min(tree.furrow.active_area, len(areas) - 1)]


def drivers_of(tree):
    return [json.loads(driver.json) for driver in tree.furrow.drivers]


def set_drivers(tree, drivers):
    tree.furrow.drivers.clear()
    for driver in drivers:
        tree.furrow.drivers.add().json = json.dumps(driver)


def free_name(name, named):
    """Return a free name: `name`, with a number appended if an item in `named` already has this name."""
    taken = {item.name for item in named}
    count, found = 1, name
    while found in taken:
        count += 1
        found = f"{name} {count}"
    return found
