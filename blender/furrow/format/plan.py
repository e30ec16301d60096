"""
Splits the drivers of a document into small steps, because each step must fit into one Blender driver.

A step combines numbers by sum, mean, minimum, maximum or a short expression. It then maps the result by a curve, which
is stored as key frames of the driver's F-curve. Blender cuts off expressions after 255 characters, but a driver of the
document may have 1024 links. Therefore sums, means, minima and maxima use Blender's driver types for them, which need
no expression. Each expression planned here reads two numbers.
"""

from dataclasses import dataclass, field

from .driver_fields import IDENTITY
from .names import find_targets

#: Driver types that Blender cannot evaluate, with a note for the panel.
UNSUPPORTED = {"tension": "tension: a driver cannot measure the deformed skin"}


@dataclass(frozen=True)
class Source:
    """
    A number that a step reads, by `kind`.

    `target`: weight of a shape key. `step`: result of another step. `rest`: resting activation of an area. `late`:
    difference between an area's delayed and undelayed activation. `input`: an input of the wrinkle set, such as the
    age. `joint`: rotation of a joint, or distance of two joints.
    """

    kind: str
    name: object


@dataclass
class Step:
    """
    A small driver.

    `curve`: points (input, output), constant beyond the ends. `slope`: factor on the combined number. A step with a
    `slope` has no curve.
    """

    name: str
    combine: str
    sources: list
    expression: str = ""
    curve: list | None = None
    slope: float | None = None


@dataclass
class Plan:
    """All steps for a document, and the drivers that cannot be planned."""

    steps: list = field(default_factory=list)
    """Steps in any order. Blender sorts drivers by dependency."""
    inputs: dict = field(default_factory=dict)
    """Initial values of the inputs, by name."""
    delays: dict = field(default_factory=dict)
    """Attack and release in seconds, by index of the delayed area."""
    missing: list = field(default_factory=list)
    """Names of targets that drivers read, but the mesh lacks."""
    unsupported: list = field(default_factory=list)
    """Notes for the panel about drivers that have no effect in Blender."""


def activation_name(area):
    """Return the name of the step that computes the activation of an area before its delay. `area`: index."""
    return f"a{area}"


def shown_name(area, delays):
    """
    Return the name of the step that computes the activation of an area including its delay.

    `area`: index. `delays`: indices of the delayed areas.
    """
    return f"s{area}" if area in delays else activation_name(area)


def plan_drivers(drivers, areas, targets, can_measure=lambda driver: False):
    """
    Plan the drivers of a document for a mesh.

    `areas`: names of all areas. `targets`: names of the mesh's shape keys. `can_measure`: function that returns whether
    the joints of a `bone` driver exist.
    """
    plan = Plan()
    weights = _Targets(plan, targets)
    for driver in drivers:
        if driver["type"] == "conflict":
            weights.add_conflict(driver["targets"])
    contributions = {area: [] for area in areas}
    cyclic = _cyclic_areas(drivers)
    for i, driver in enumerate(drivers):
        links = _links_of(driver, weights, areas, cyclic, can_measure, plan)
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
    """Stores the source of each target's weight: a shape key, or a step if a driver of type `conflict` reduces it."""

    def __init__(self, plan, targets):
        self.plan = plan
        self.targets = targets
        self.sources = [Source("target", name) for name in targets]
        self.conflicts = 0

    def find(self, name):
        """
        Return the sources whose mean is the weight of a target.

        If the mesh lacks the target, returns an empty list and adds the name to the missing ones.
        """
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


def _links_of(driver, weights, areas, cyclic, can_measure, plan):
    """
    Return a driver's links as tuples (sources, weight, curve), or None if the driver adds no number to an area.

    If Blender cannot evaluate the driver, adds a note to `plan.unsupported`.
    """
    kind = driver["type"]
    if kind == "morph":
        return [(weights.find(link["name"]), link["weight"], link.get("curve")) for link in driver["targets"]]
    if kind == "muscle" and "area" in driver:
        return [(weights.find(driver["name"]), 1, None)]
    if kind == "area":
        if driver["area"] in cyclic:
            plan.unsupported.append(f'"{driver["area"]}" drives itself')
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
        plan.unsupported.append(f'joint "{driver["joints"][1]}" measured from "{driver["joints"][0]}"')
    elif kind in UNSUPPORTED:
        note = UNSUPPORTED[kind]
        if note not in plan.unsupported:
            plan.unsupported.append(note)
    elif kind not in ("conflict", "expression", "muscle", "time"):
        plan.unsupported.append(f'drivers of type "{kind}"')
    return None


def _add_driver(plan, name, driver, links):
    """Add the steps of a driver to the plan. Returns the source of the driver's contribution to its area."""
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
    """Return the areas that depend on themselves: their drivers read them, directly or through other areas."""
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
