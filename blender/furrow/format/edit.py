"""Edits lists of drivers and shape corrections, and describes drivers. No function changes its arguments."""

import copy

from .driver_fields import IDENTITY


def link_target(drivers, area, target, weight=1, start=0, full=1):
    """
    Let a morph target activate an area.

    The activation starts when the target's weight reaches `start`, and is full at the weight `full`. `weight` scales
    the activation. The target is added to the area's first `morph` driver that has the default rule and curve, or to a
    new driver. If the driver already reads the target, the new link replaces the old one.
    """
    link = {"name": target, "weight": weight}
    if (start, full) != (0, 1):
        link["curve"] = [[start, 0], [full, 1]]
    out = copy.deepcopy(drivers)
    for driver in out:
        if driver["type"] == "morph" and (driver["area"], driver["rule"], driver["curve"]) == (area, "sum", IDENTITY):
            driver["targets"] = [*(item for item in driver["targets"] if item["name"] != target), link]
            return out
    return [*out, {"type": "morph", "area": area, "targets": [link], "rule": "sum", "curve": IDENTITY}]


def remove_link(drivers, index, target):
    """Remove the link to `target` from `drivers[index]`. Removes the driver if no link remains."""
    out = copy.deepcopy(drivers)
    out[index]["targets"] = [item for item in out[index]["targets"] if item["name"] != target]
    return out if out[index]["targets"] else out[:index] + out[index + 1 :]


def remove_area(drivers, area):
    """Remove all drivers of an area, and all links that read it."""
    out = []
    for driver in copy.deepcopy(drivers):
        if driver.get("area") == area:
            continue
        for field, name in (("areas", "name"), ("activations", "area")):
            if isinstance(driver.get(field), list):
                driver[field] = [item for item in driver[field] if item.get(name) != area]
        if driver["type"] != "area" or driver["areas"]:
            out.append(driver)
    return out


def rename_area(drivers, old, new):
    out = copy.deepcopy(drivers)
    for driver in out:
        if driver.get("area") == old:
            driver["area"] = new
        for field, name in (("areas", "name"), ("activations", "area")):
            for item in driver.get(field, []) if isinstance(driver.get(field), list) else []:
                if item.get(name) == old:
                    item[name] = new
    return out


def rename_joints(drivers, names):
    """Rename the joints of `bone` drivers. `names`: new names by old names."""
    return [
        {**driver, "joints": [names.get(name, name) for name in driver["joints"]]}
        if driver["type"] == "bone"
        else driver
        for driver in drivers
    ]


def meshes_of(shapes):
    """List the distinct mesh names in `shapes`, the document's list of shape corrections. Skips malformed items."""
    items = shapes if isinstance(shapes, list) else []
    names = [item.get("mesh") for item in items if isinstance(item, dict)]
    return list(dict.fromkeys(name for name in names if isinstance(name, str)))


def rename_meshes(shapes, names):
    """Rename the meshes in shape corrections. `names`: new names by old names."""
    if not meshes_of(shapes):
        return shapes

    def renamed(item):
        return {**item, "mesh": names.get(item["mesh"], item["mesh"])} if meshes_of([item]) else item

    return [renamed(item) for item in shapes]


def describe_driver(driver):
    """Describe a driver in one line for the panel."""
    if driver["type"] in ("morph", "area"):
        links = driver.get("targets") or driver.get("areas")
        joined = " + ".join(f"{item['weight']:g} {item['name']}" for item in links)
        return f"{driver['rule']} of {joined}" if driver["rule"] != "sum" else joined
    if driver["type"] == "bone":
        return f"{driver['measure']} of {driver['joints'][1]} from {driver['joints'][0]}"
    if driver["type"] in ("input", "muscle"):
        return f"{driver['type']} {driver['name']}"
    if driver["type"] == "time":
        return f"rises in {driver['attack']:g} s, falls in {driver['release']:g} s"
    return driver["type"]
