"""
Finds morph targets by name, in the spellings of different rigs.

The rules equal those in `packages/furrow/src/drivers/morph/target-names.ts`.
"""

import json
import re
from pathlib import Path

#: Lists of names for the same shape. The first name of a list is the canonical name. The command
#: `npm test -- test/unit/blender/aliases.test.ts -u` writes `aliases.json`.
ALIASES = json.loads(Path(__file__).with_name("aliases.json").read_text("utf-8"))

_PREFIXES = (re.compile(r"^.*\.(?=[^.]{2})"), re.compile(r"^M_F\d+(_\d+)*_", re.I), re.compile(r"^BS_", re.I))


def find_targets(name, targets):
    """
    Return the indices of the targets that a name refers to.

    Searches for a target with exactly this name, then one with another spelling, then the left and right halves of a
    shape. Returns an empty list if there are none.
    """
    if name in targets:
        return [targets.index(name)]
    keys = [_key(canonical_name(target)) for target in targets]
    key = _key(canonical_name(name))
    if key in keys:
        return [keys.index(key)]
    return [keys.index(half) for half in (f"{key}left", f"{key}right") if half in keys]


def canonical_name(name):
    """
    Return the canonical name of a target, for example `browOuterUpLeft` for `blendShape1.browOuterUp_L`.

    For unknown shapes, removes the prefixes in `_PREFIXES`, and replaces `_L` or `_R` at the end by `Left` or `Right`.
    """
    known = _CANONICAL.get(_key(name))
    if known:
        return known
    plain = name
    for prefix in _PREFIXES:
        plain = prefix.sub("", plain, count=1)
    plain = _with_side(plain)
    return _CANONICAL.get(_key(plain), plain)


def _with_side(name):
    return re.sub(r"[_. -]R$", "Right", re.sub(r"[_. -]L$", "Left", name))


def _key(name):
    letters = "".join(c for c in _with_side(name).lower() if c.isalnum())
    return letters or name


_CANONICAL = {_key(name): names[0] for names in ALIASES for name in names}
