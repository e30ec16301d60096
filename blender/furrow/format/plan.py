"""
Drivers as many small ones, the way Blender evaluates them.

Each step is one driver in Blender: it combines numbers by sum, mean, minimum, maximum or a short expression, and maps
the result through a curve, which becomes the key frames of the driver's F-curve. One driver of the extension may have
1024 links; a single expression of Blender is cut off at 255 characters, so that no expression here reads more than four
numbers.
"""

from dataclasses import dataclass, field

from .driver_fields import IDENTITY
from .names import find_targets

#: Types that need what Blender's drivers do not have, and why.
NOT_IN_BLENDER = {"tension": "tension: a driver cannot measure the deformed skin"}


@dataclass(frozen=True)
class Source:
    """
    A number that a step reads: a `target`'s weight, another `step`, an area at `rest`, how `late` it is, an `input`, a
    `joint` measured.
    """

    kind: str
    name: object


@dataclass
class Step:
    """One small driver. `curve`: points, constant beyond the ends; or `slope`: a factor; or neither."""

    name: str
    combine: str
    sources: list
    expression: str = ""
    curve: list | None = None
    slope: float | None = None


@dataclass
class Plan:
    """The small drivers, and what remains data. Blender orders the steps by what they read."""

    steps: list = field(default_factory=list)
    inputs: dict = field(default_factory=dict)
    """Initial values by name."""
    delays: dict = field(default_factory=dict)
    """Attack and release in seconds, by the index of the area."""
    missing: list = field(default_factory=list)
    """Targets and joints that drivers name and the model lacks."""
    kept: list = field(default_factory=list)
    """What is not shown in Blender, for people."""


def activation_name(area):
    """Name of the step that gives the activation of an area, by its index, before any delay."""
    return f"a{area}"


def shown_name(area, delays):
    """Name of the step that gives what is shown of an area, by its index. `delays`: the areas that have one."""
    return f"s{area}" if area in delays else activation_name(area)


def plan_drivers(drivers, areas, targets, can_measure=lambda driver: False):
    """
    Plan the drivers of a document for a mesh.

    `areas`: names of all areas. `targets`: names of the mesh's shape keys. `can_measure`: whether a `bone` driver's
    joints are there.
    """
    plan = Plan()
    reads = _Targets(plan, targets)
    for driver in drivers:
        if driver["type"] == "conflict":
            reads.add_conflict(driver["targets"])
    contributions = {area: [] for area in areas}
    cyclic = _cyclic_areas(drivers)
    for i, driver in enumerate(drivers):
        links = _links_of(driver, reads, areas, cyclic, can_measure, plan)
        if links is not None:
            contributions[driver["area"]].append(_add_driver(plan, f"d{i}", driver, links))
        elif driver["type"] == "time":
            plan.delays[areas.index(driver["area"])] = (driver["attack"], driver["release"])
    for i, area in enumerate(areas):
        sources = [Source("rest", i), *contributions[area]]
        plan.steps.append(Step(activation_name(i), "SUM", sources, curve=IDENTITY))
        if i in plan.delays:
            late = [Source("step", activation_name(i)), Source("late", i)]
            plan.steps.append(Step(shown_name(i, plan.delays), "SUM", late, curve=IDENTITY))
    return plan


class _Targets:
    """The weights of targets as drivers read them: after the conflicts."""

    def __init__(self, plan, targets):
        self.plan = plan
        self.targets = targets
        self.sources = [Source("target", name) for name in targets]
        self.conflicts = 0

    def of(self, name):
        """Sources whose mean a name means; none if the model lacks it."""
        found = find_targets(name, self.targets)
        if not found and name not in self.plan.missing:
            self.plan.missing.append(name)
        return [self.sources[i] for i in found]

    def add_conflict(self, names):
        both = [find_targets(name, self.targets) for name in names]
        if not all(both):
            self.plan.missing.extend(name for name, found in zip(names, both, strict=True) if not found)
            return
        at = f"c{self.conflicts}"
        self.conflicts += 1
        means = [_mean(self.plan, f"{at}m{k}", [self.sources[i] for i in found]) for k, found in enumerate(both)]
        self.plan.steps.append(Step(at, "SCRIPTED", means, "max(0,min(a,b))"))
        for found in both:
            for i in found:
                name = f"{at}t{i}" if self.sources[i].name != f"{at}t{i}" else f"{at}u{i}"
                self.plan.steps.append(Step(name, "SCRIPTED", [self.sources[i], Source("step", at)], "a-b"))
                self.sources[i] = Source("step", name)


def _mean(plan, name, sources):
    if len(sources) == 1:
        return sources[0]
    plan.steps.append(Step(name, "AVERAGE", sources))
    return Source("step", name)


def _links_of(driver, reads, areas, cyclic, can_measure, plan):
    """The links of a driver as (sources, weight, curve); None where it activates nothing here."""
    kind = driver["type"]
    if kind == "morph":
        return [(reads.of(link["name"]), link["weight"], link.get("curve")) for link in driver["targets"]]
    if kind == "muscle" and "area" in driver:
        return [(reads.of(driver["name"]), 1, None)]
    if kind == "area":
        if driver["area"] in cyclic:
            plan.kept.append(f'"{driver["area"]}" drives itself')
            return None
        return [
            ([Source("step", activation_name(areas.index(link["name"])))], link["weight"], link.get("curve"))
            for link in driver["areas"]
        ]
    if kind in ("age", "input"):
        name = "age" if kind == "age" else driver["name"]
        plan.inputs.setdefault(name, driver["initial"] if kind == "age" else 0)
        return [([Source("input", name)], 1, None)]
    if kind == "bone":
        if can_measure(driver):
            axis = tuple(driver["axis"]) if "axis" in driver else None
            return [([Source("joint", (*driver["joints"], driver["measure"], axis))], 1, None)]
        plan.kept.append(f'joint "{driver["joints"][1]}" measured from "{driver["joints"][0]}"')
    elif kind in NOT_IN_BLENDER:
        note = NOT_IN_BLENDER[kind]
        if note not in plan.kept:
            plan.kept.append(note)
    elif kind not in ("conflict", "expression", "muscle", "time"):
        plan.kept.append(f'drivers of type "{kind}"')
    return None


def _add_driver(plan, name, driver, links):
    """Add the steps of one driver; the source of what it adds to its area."""
    values = []
    for k, (sources, weight, curve) in enumerate(links):
        if len(sources) == 1 and weight == 1 and curve is None:
            values.append(sources[0])
            continue
        at = f"{name}l{k}"
        scaled = [[x, y * weight] for x, y in curve] if curve else None
        slope = weight if curve is None and weight != 1 else None
        plan.steps.append(Step(at, "AVERAGE" if len(sources) > 1 else "SUM", sources, curve=scaled, slope=slope))
        values.append(Source("step", at))
    curve = driver.get("curve", IDENTITY)
    rule = driver.get("rule", "sum")
    if rule == "product":
        product = values[0]
        for k, value in enumerate(values[1:]):
            plan.steps.append(Step(f"{name}p{k}", "SCRIPTED", [product, value], "a*b"))
            product = Source("step", f"{name}p{k}")
        values, rule = [product], "sum"
    plan.steps.append(Step(name, {"sum": "SUM", "max": "MAX", "min": "MIN"}[rule], values, curve=curve))
    return Source("step", name)


def _cyclic_areas(drivers):
    """Areas that drive themselves, directly or through others."""
    reads = {}
    for driver in drivers:
        if driver["type"] == "area":
            reads.setdefault(driver["area"], set()).update(link["name"] for link in driver["areas"])

    def reached(area):
        seen, open_areas = set(), list(reads.get(area, ()))
        while open_areas:
            found = open_areas.pop()
            if found not in seen:
                seen.add(found)
                open_areas.extend(reads.get(found, ()))
        return seen

    return {area for area in reads if area in reached(area)}
