"""Names of morph targets in different rigs. Matches `packages/furrow/src/drivers/morph/target-names.ts`."""

import json
import re
from pathlib import Path

#: One list per shape, canonical name first. `npm test -- test/unit/blender/aliases.test.ts -u` writes the file.
ALIASES = json.loads(Path(__file__).with_name("aliases.json").read_text("utf-8"))

_PREFIXES = (re.compile(r"^.*\.(?=[^.]{2})"), re.compile(r"^M_F\d+(_\d+)*_", re.I), re.compile(r"^BS_", re.I))


def find_targets(name, targets):
    """
    Find the indices of the targets for a name: an exact match, else another spelling, else the left and right halves.

    Returns an empty list if nothing matches.
    """
    if name in targets:
        return [targets.index(name)]
    keys = [_key(canonical_name(target)) for target in targets]
    key = _key(canonical_name(name))
    if key in keys:
        return [keys.index(key)]
    return [keys.index(half) for half in (f"{key}left", f"{key}right") if half in keys]


def canonical_name(name):
    """Convert `blendShape1.browOuterUp_L` to `browOuterUpLeft`. Only strips the prefix of unknown shapes."""
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
