"""Edits of a document's drivers. All functions return new lists."""

import copy

from .driver_fields import IDENTITY


def link_target(drivers, area, target, weight=1, start=0, full=1):
    """
    Let a morph target activate an area, starting at weight `start` and fully at `full`.

    Adds the link to the area's first `morph` driver with default rule and curve, or to a new one. Replaces a link to
    the same target.
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
    """Remove a link, and its driver if no link remains."""
    out = copy.deepcopy(drivers)
    out[index]["targets"] = [item for item in out[index]["targets"] if item["name"] != target]
    return out if out[index]["targets"] else out[:index] + out[index + 1 :]


def remove_area(drivers, area):
    """Remove all drivers and links of an area."""
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
    """Rename an area in all drivers."""
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
    """Rename joints. `names`: new names by old ones."""
    return [
        {**driver, "joints": [names.get(name, name) for name in driver["joints"]]}
        if driver["type"] == "bone"
        else driver
        for driver in drivers
    ]


def meshes_of(shapes):
    """List the distinct mesh names in shape corrections. Malformed corrections are skipped."""
    items = shapes if isinstance(shapes, list) else []
    names = [item.get("mesh") for item in items if isinstance(item, dict)]
    return list(dict.fromkeys(name for name in names if isinstance(name, str)))


def rename_meshes(shapes, names):
    """Rename meshes in shape corrections. `names`: new names by old ones."""
    if not meshes_of(shapes):
        return shapes

    def renamed(item):
        return {**item, "mesh": names.get(item["mesh"], item["mesh"])} if meshes_of([item]) else item

    return [renamed(item) for item in shapes]


def describe_driver(driver):
    """Describe a driver in one line for the interface."""
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
