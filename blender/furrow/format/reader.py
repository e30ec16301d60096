"""Checks of JSON, field by field: every error names the field by its path."""

import math
import re
import unicodedata

LARGEST = 1000
LONGEST_NAME = 256


class FurrowError(Exception):
    """What is wrong: who, what, the value, the limit, the remedy."""


class Reader:
    """Reads one JSON document. `who` begins every error."""

    def __init__(self, who):
        self.who = who

    def fail(self, what, value, limit, remedy):
        """Raise FurrowError."""
        shown = "nothing" if value is None else repr(value)
        parts = [f"{what}, got {shown if len(shown) <= 80 else shown[:77] + '...'}"]
        if limit:
            parts.append(f"allowed is {limit}")
        raise FurrowError(f"{self.who}: {', '.join(parts)}; {remedy}")

    def object(self, value, path):
        """The value as an object."""
        if not isinstance(value, dict):
            self.fail(f"{path} must be an object", value, None, "write { ... }")
        return value

    def array(self, value, path, low, high):
        """The value as an array of `low` to `high` items."""
        limit = f"{low} to {high} items"
        if not isinstance(value, list):
            self.fail(f"{path} must be an array", value, limit, "write [ ... ]")
        if not low <= len(value) <= high:
            self.fail(f"{path} has the wrong number of items", len(value), limit, "add or remove items")
        return value

    def number(self, value, path, low, high):
        """The value as a finite number from `low` to `high`."""
        limit = f"{low} to {high}"
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
            self.fail(f"{path} must be a number", value, limit, "write a plain number")
        if not low <= value <= high:
            self.fail(f"{path} is out of range", value, limit, "choose a value inside the range")
        return value

    def integer(self, value, path, low, high):
        """The value as a whole number from `low` to `high`."""
        number = self.number(value, path, low, high)
        if number != int(number):
            self.fail(f"{path} must be a whole number", value, f"{low} to {high}", "write it without a fraction")
        return int(number)

    def text(self, value, path):
        """The value as text of 1 to 256 characters."""
        if not isinstance(value, str) or not 1 <= len(value) <= LONGEST_NAME:
            self.fail(f"{path} must be text", value, f"1 to {LONGEST_NAME} characters", "write it in quotes")
        return value

    def name(self, value, path):
        """The value as the name of a layer or area."""
        if not is_name(value):
            limit = f"1 to {LONGEST_NAME} characters without line breaks"
            self.fail(f"{path} must be text", value, limit, "choose another name")
        return value

    def choice(self, value, path, allowed):
        """The value as one of `allowed`."""
        if value not in allowed:
            self.fail(f"{path} is unknown", value, " or ".join(map(str, allowed)), "use one of them")
        return value

    def curve(self, value, path, low, high):
        """Points [input, output] with increasing inputs and outputs from `low` to `high`."""
        points = []
        for i, point in enumerate(self.array(value, path, 2, 64)):
            x, y = self.array(point, f"{path}[{i}]", 2, 2)
            self.number(x, f"{path}[{i}][0]", -LARGEST, LARGEST)
            self.number(y, f"{path}[{i}][1]", low, high)
            if points and x <= points[-1][0]:
                self.fail(f"{path}[{i}][0] does not increase", x, f"more than {points[-1][0]}", "sort the points")
            points.append([x, y])
        return points


def is_name(value):
    """
    Whether a value can name a layer or an area: no control characters, no line breaks, no halves of surrogate pairs.
    """
    if not isinstance(value, str) or not 1 <= len(value) <= LONGEST_NAME:
        return False
    return not re.search("[\u2028\u2029]", value) and not any(unicodedata.category(c) in ("Cc", "Cs") for c in value)
