"""Evaluates the steps of a plan in float64, as a reference for tests."""

import math
from itertools import pairwise


def evaluate_plan(plan, read):
    """Return the values of all steps by name. `read`: function that returns the value of a source that is no step."""
    values = {}
    pending = list(plan.steps)
    while pending:
        ready = [s for s in pending if all(r.kind != "step" or r.name in values for r in s.sources)]
        for step in ready:
            numbers = [values[r.name] if r.kind == "step" else read(r) for r in step.sources]
            values[step.name] = _shape(step, _combine(step, numbers))
        pending = [step for step in pending if step.name not in values]
    return values


def curve_at(curve, x):
    """Evaluate a piecewise linear curve at `x`. It is constant beyond its ends."""
    if not x > curve[0][0]:
        return curve[0][1]
    for (x0, y0), (x1, y1) in pairwise(curve):
        if x <= x1:
            t = (x - x0) / (x1 - x0)
            return y0 * (1 - t) + y1 * t
    return curve[-1][1]


def _combine(step, numbers):
    if step.combine == "SCRIPTED":
        names = dict(zip("abcd", numbers, strict=False))
        return eval(step.expression, {"__builtins__": {}, "max": max, "min": min}, names)
    if not numbers:
        return 0
    if step.combine == "AVERAGE":
        return math.fsum(numbers) / len(numbers)
    return {"SUM": math.fsum, "MIN": min, "MAX": max}[step.combine](numbers)


def _shape(step, value):
    if step.curve:
        return curve_at(step.curve, value)
    return value if step.slope is None else value * step.slope
