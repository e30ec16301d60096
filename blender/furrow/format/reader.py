"""Checks JSON field by field. Errors have the path of the field."""

import json
import math
import re
import unicodedata

MAX_NUMBER = 1000
MAX_NAME_LENGTH = 256
NAME_RULE = f"1 to {MAX_NAME_LENGTH} characters, none of them a control character or a line break"


class FurrowError(Exception):
    """Error of the form `module: problem, got VALUE, allowed: LIMIT; remedy`."""


class Reader:
    """Reads a JSON document. Every error starts with `who`."""

    def __init__(self, who):
        self.who = who

    def fail(self, problem, value, limit, remedy):
        """Raise FurrowError."""
        shown = (
            "nothing" if value is None else json.dumps(value, ensure_ascii=False, separators=(",", ":"), default=repr)
        )
        parts = [f"{problem}, got {shown if len(shown) <= 120 else shown[:117] + '...'}"]
        if limit:
            parts.append(f"allowed: {limit}")
        raise FurrowError(f"{self.who}: {', '.join(parts)}; {remedy}")

    def object(self, value, path):
        """Check an object."""
        if not isinstance(value, dict):
            self.fail(f"{path} must be an object", value, None, "write { ... }")
        return value

    def array(self, value, path, low, high):
        """Check an array of `low` to `high` items."""
        limit = f"{low} to {high} items"
        if not isinstance(value, list):
            self.fail(f"{path} must be an array", value, limit, "write [ ... ]")
        if not low <= len(value) <= high:
            self.fail(f"{path} has the wrong number of items", len(value), limit, "add or remove items")
        return value

    def number(self, value, path, low, high):
        """Check a finite number from `low` to `high`."""
        limit = f"{low}..{high}"
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            self.fail(f"{path} must be a number", value, limit, "write a plain number")
        if not low <= value <= high:
            self.fail(f"{path} is out of range", value, limit, "choose a value inside the range")
        return value

    def integer(self, value, path, low, high):
        """Check an integer from `low` to `high`."""
        number = self.number(value, path, low, high)
        if number != int(number):
            self.fail(f"{path} must be a whole number", value, f"{low}..{high}", "write it without a fraction")
        return int(number)

    def text(self, value, path):
        """Check text of 1 to 256 characters."""
        if not isinstance(value, str) or not 1 <= len(value) <= MAX_NAME_LENGTH:
            self.fail(f"{path} must be text", value, f"1 to {MAX_NAME_LENGTH} characters", "write it in quotes")
        return value

    def name(self, value, path):
        """Check the name of a layer or area."""
        if not is_name(value):
            self.fail(f"{path} must be text", value, NAME_RULE, "choose another name")
        return value

    def choice(self, value, path, allowed):
        """Check a value from `allowed`."""
        if value not in allowed:
            self.fail(f"{path} is unknown", value, " or ".join(map(str, allowed)), "use one of them")
        return value

    def curve(self, value, path, low, high):
        """Check points [input, output] with increasing inputs, and outputs from `low` to `high`."""
        points = []
        for i, point in enumerate(self.array(value, path, 2, 64)):
            x, y = self.array(point, f"{path}[{i}]", 2, 2)
            self.number(x, f"{path}[{i}][0]", -MAX_NUMBER, MAX_NUMBER)
            self.number(y, f"{path}[{i}][1]", low, high)
            if points and x <= points[-1][0]:
                limit = f"more than {points[-1][0]}"
                self.fail(f"{path}[{i}][0] does not increase", x, limit, "sort the points by their input")
            points.append([x, y])
        return points


def is_name(value):
    """Whether a value can name a layer or area: no control characters, line breaks or unpaired surrogates."""
    if not isinstance(value, str) or not 1 <= len(value) <= MAX_NAME_LENGTH:
        return False
    return not re.search("[\u2028\u2029]", value) and not any(unicodedata.category(c) in ("Cc", "Cs") for c in value)
