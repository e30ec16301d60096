"""Checks values of a JSON document. Error messages include the path of the value."""

import json
import math
import re
import unicodedata

MAX_NUMBER = 1000
MAX_NAME_LENGTH = 256
NAME_RULE = f"1 to {MAX_NAME_LENGTH} characters, none of them a control character or a line break"


class FurrowError(Exception):
    """An error for the user, with a message of the form `module: problem, got VALUE, allowed: LIMIT; remedy`."""


class Reader:
    """
    Checks values of a JSON document. Every error message starts with `who`.

    The methods return the checked value, and raise FurrowError if it is invalid. `path` is the value's path for the
    message, such as `areas[2].name`.
    """

    def __init__(self, who):
        self.who = who

    def fail(self, problem, value, limit, remedy):
        """Raise FurrowError. `limit` is omitted from the message if it is None."""
        shown = (
            "nothing" if value is None else json.dumps(value, ensure_ascii=False, separators=(",", ":"), default=repr)
        )
        parts = [f"{problem}, got {shown if len(shown) <= 120 else shown[:117] + '...'}"]
        if limit:
            parts.append(f"allowed: {limit}")
        raise FurrowError(f"{self.who}: {', '.join(parts)}; {remedy}")

    def object(self, value, path):
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
        number = self.number(value, path, low, high)
        if number != int(number):
            self.fail(f"{path} must be a whole number", value, f"{low}..{high}", "write it without a fraction")
        return int(number)

    def text(self, value, path):
        if not isinstance(value, str) or not 1 <= len(value) <= MAX_NAME_LENGTH:
            self.fail(f"{path} must be text", value, f"1 to {MAX_NAME_LENGTH} characters", "write it in quotes")
        return value

    def name(self, value, path):
        if not is_name(value):
            self.fail(f"{path} must be text", value, NAME_RULE, "choose another name")
        return value

    def choice(self, value, path, allowed):
        if value not in allowed:
            self.fail(f"{path} is unknown", value, " or ".join(map(str, allowed)), "use one of them")
        return value

    def curve(self, value, path, low, high):
        """Check 2 to 64 points [input, output]. Inputs must increase, and outputs must be from `low` to `high`."""
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
    """
    Return whether a value is a valid name of a layer or area.

    Names have 1 to 256 characters. They have no control characters, line breaks or unpaired surrogates.
    """
    if not isinstance(value, str) or not 1 <= len(value) <= MAX_NAME_LENGTH:
        return False
    return not re.search("[\u2028\u2029]", value) and not any(unicodedata.category(c) in ("Cc", "Cs") for c in value)
