"""What the operators share."""

import json

from ..format.reader import FurrowError
from ..material import wrinkle_group


class OnWrinkles:
    """An operator on the wrinkle set of the active material. `run` does the work; a FurrowError becomes a report."""

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
    """The chosen area. Raises FurrowError where there is none."""
    areas = tree.furrow.areas
    if not areas:
        raise FurrowError("Furrow: there is no area; add one first")
    return areas[min(tree.furrow.active_area, len(areas) - 1)]


def drivers_of(tree):
    """The drivers as a list of plain data."""
    return [json.loads(driver.json) for driver in tree.furrow.drivers]


def set_drivers(tree, drivers):
    """Replace the drivers."""
    tree.furrow.drivers.clear()
    for driver in drivers:
        tree.furrow.drivers.add().json = json.dumps(driver)


def free_name(name, named):
    """The name, with a number behind it if it is taken."""
    taken = {item.name for item in named}
    count, found = 1, name
    while found in taken:
        count += 1
        found = f"{name} {count}"
    return found
