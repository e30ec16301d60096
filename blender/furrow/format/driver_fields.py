"""Checks the fields of drivers, which depend on the type of the driver. Drivers of unknown types are kept unchanged."""

import math

from .reader import MAX_NUMBER

IDENTITY = [[0, 0], [1, 1]]
RULES = ("sum", "max", "min", "product")
MAX_LINKS = 1024


def read_driver(reader, item, at, areas):
    """Check a driver and fill in defaults. Returns a new dict."""
    driver = dict(reader.object(item, at))
    kind = reader.text(driver.get("type"), f"{at}.type")
    if kind in _FIELDS:
        _FIELDS[kind](reader, driver, at, areas)
    return driver


def _area(reader, driver, at, areas):
    reader.choice(driver.get("area"), f"{at}.area", areas)


def _curve(reader, driver, at, default=None):
    driver["curve"] = reader.curve(driver.get("curve", default), f"{at}.curve", 0, 1)


def _links(reader, driver, at, field, known=None):
    links = []
    for i, item in enumerate(reader.array(driver.get(field), f"{at}.{field}", 1, MAX_LINKS)):
        path = f"{at}.{field}[{i}]"
        link = dict(reader.object(item, path))
        if known is None:
            reader.text(link.get("name"), f"{path}.name")
        else:
            reader.choice(link.get("name"), f"{path}.name", known)
        link["weight"] = reader.number(link.get("weight", 1), f"{path}.weight", -MAX_NUMBER, MAX_NUMBER)
        if "curve" in link:
            link["curve"] = reader.curve(link["curve"], f"{path}.curve", -MAX_NUMBER, MAX_NUMBER)
        links.append(link)
    driver[field] = links
    driver["rule"] = reader.choice(driver.get("rule", "sum"), f"{at}.rule", RULES)


def _names(reader, driver, at, field):
    for i, name in enumerate(reader.array(driver.get(field), f"{at}.{field}", 2, 2)):
        reader.text(name, f"{at}.{field}[{i}]")


def _vector(reader, driver, at, field, size):
    values = reader.array(driver.get(field), f"{at}.{field}", size, size)
    for i, value in enumerate(values):
        reader.number(value, f"{at}.{field}[{i}]", -MAX_NUMBER, MAX_NUMBER)
    return values


def _direction(reader, driver, at, field, size):
    if field in driver and math.hypot(*_vector(reader, driver, at, field, size)) == 0:
        zeros, example = ", ".join(["0"] * size), ", ".join(["1", "0", "0"][:size])
        reader.fail(f"{at}.{field} has length zero", zeros, None, f"write e.g. [{example}]")


def _morph(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    _links(reader, driver, at, "targets")
    _curve(reader, driver, at, IDENTITY)


def _area_links(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    _links(reader, driver, at, "areas", areas)
    _curve(reader, driver, at, IDENTITY)


def _conflict(reader, driver, at, _areas):
    _names(reader, driver, at, "targets")


def _bone(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    _names(reader, driver, at, "joints")
    reader.choice(driver.get("measure"), f"{at}.measure", ("angle", "distance"))
    _direction(reader, driver, at, "axis", 3)
    _curve(reader, driver, at)


def _tension(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    driver["measure"] = reader.choice(driver.get("measure", "compression"), f"{at}.measure", ("compression", "stretch"))
    _direction(reader, driver, at, "direction", 2)
    _curve(reader, driver, at)


def _muscle(reader, driver, at, areas):
    reader.text(driver.get("name"), f"{at}.name")
    if "area" in driver:
        _area(reader, driver, at, areas)
    driver["kind"] = reader.choice(driver.get("kind", "linear"), f"{at}.kind", ("linear", "sheet", "sphincter"))
    origin, insertion = (_vector(reader, driver, at, field, 3) for field in ("origin", "insertion"))
    if origin == insertion:
        shown = ", ".join(f"{value:g}" for value in insertion)
        reader.fail(f"{at}.insertion equals the origin", shown, None, "move one of the two points")
    ranges = {
        "angle": (0.001, 1.57, 0.5),
        "width": (0.0001, MAX_NUMBER, 0.01),
        "inner": (0, 10, 0.8),
        "outer": (0.001, 10, 1.2),
        "strength": (-1, 1, 0.3),
    }
    for field, (low, high, default) in ranges.items():
        driver[field] = reader.number(driver.get(field, default), f"{at}.{field}", low, high)
    if driver["outer"] <= driver["inner"]:
        limit = f"more than {driver['inner']}"
        reader.fail(f"{at}.outer is too small", driver["outer"], limit, "make outer larger than inner")


def _age(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    _curve(reader, driver, at)
    driver["initial"] = reader.number(driver.get("initial", 20), f"{at}.initial", -MAX_NUMBER, MAX_NUMBER)


def _input(reader, driver, at, areas):
    reader.text(driver.get("name"), f"{at}.name")
    _area(reader, driver, at, areas)
    _curve(reader, driver, at)


def _time(reader, driver, at, areas):
    _area(reader, driver, at, areas)
    for field in ("attack", "release"):
        driver[field] = reader.number(driver.get(field, 0), f"{at}.{field}", 0, 60)


def _expression(reader, driver, at, areas):
    reader.text(driver.get("name"), f"{at}.name")
    for field, name, value, low in (
        ("targets", "name", "weight", -MAX_NUMBER),
        ("activations", "area", "activation", 0),
    ):
        items = []
        for i, item in enumerate(reader.array(driver.get(field, []), f"{at}.{field}", 0, MAX_LINKS)):
            path = f"{at}.{field}[{i}]"
            entry = dict(reader.object(item, path))
            if field == "targets":
                reader.text(entry.get(name), f"{path}.{name}")
            else:
                reader.choice(entry.get(name), f"{path}.{name}", areas)
            high = MAX_NUMBER if field == "targets" else 1
            entry[value] = reader.number(entry.get(value, 1), f"{path}.{value}", low, high)
            items.append(entry)
        driver[field] = items


_FIELDS = {
    "morph": _morph,
    "area": _area_links,
    "conflict": _conflict,
    "bone": _bone,
    "tension": _tension,
    "muscle": _muscle,
    "age": _age,
    "input": _input,
    "time": _time,
    "expression": _expression,
}
