"""Edits of the drivers of a document: lists of drivers in, new lists out."""

import copy

from .driver_fields import IDENTITY


def link_target(drivers, area, target, weight=1, start=0, full=1):
    """
    Let a morph target activate an area, from a weight of `start` on and fully at `full`.

    It joins the area's first driver of type `morph` that sums its links as they are, or becomes a new one. A link to
    the same target is replaced.
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


def without_link(drivers, index, target):
    """Remove a link of a driver, and the driver with its last one."""
    out = copy.deepcopy(drivers)
    out[index]["targets"] = [item for item in out[index]["targets"] if item["name"] != target]
    return out if out[index]["targets"] else out[:index] + out[index + 1 :]


def without_area(drivers, area):
    """Remove what drives an area or reads it."""
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


def with_area_renamed(drivers, old, new):
    """The same with another name of an area."""
    out = copy.deepcopy(drivers)
    for driver in out:
        if driver.get("area") == old:
            driver["area"] = new
        for field, name in (("areas", "name"), ("activations", "area")):
            for item in driver.get(field, []) if isinstance(driver.get(field), list) else []:
                if item.get(name) == old:
                    item[name] = new
    return out


def with_joints_renamed(drivers, names):
    """The same with other names of joints, by the old ones."""
    return [
        {**driver, "joints": [names.get(name, name) for name in driver["joints"]]}
        if driver["type"] == "bone"
        else driver
        for driver in drivers
    ]


def meshes_of(shapes):
    """Names of the meshes that corrections of shapes name, each once. Malformed ones name none."""
    items = shapes if isinstance(shapes, list) else []
    names = [item.get("mesh") for item in items if isinstance(item, dict)]
    return list(dict.fromkeys(name for name in names if isinstance(name, str)))


def with_meshes_renamed(shapes, names):
    """Corrections of shapes with other names of meshes, by the old ones."""
    if not meshes_of(shapes):
        return shapes

    def renamed(item):
        return {**item, "mesh": names.get(item["mesh"], item["mesh"])} if meshes_of([item]) else item

    return [renamed(item) for item in shapes]


def describe_driver(driver):
    """One line for people."""
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
