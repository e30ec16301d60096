"""Names of morph targets in different rigs, as `packages/furrow/src/drivers/morph/target-names.ts` has them."""

import json
import re
from pathlib import Path

#: One list per shape, its canonical name first; written from the library's by `npm run blender:aliases`, compared by a
# test.
ALIASES = json.loads(Path(__file__).with_name("aliases.json").read_text("utf-8"))

_PREFIXES = (re.compile(r"^.*\.(?=[^.]{2})"), re.compile(r"^M_F\d+(_\d+)*_", re.I), re.compile(r"^BS_", re.I))


def find_targets(name, targets):
    """
    Indices of the targets that a name means: itself, else the same shape in another spelling, else its two halves.

    Empty if there are none.
    """
    if name in targets:
        return [targets.index(name)]
    plain = [_key(canonical_name(target)) for target in targets]
    wanted = _key(canonical_name(name))
    if wanted in plain:
        return [plain.index(wanted)]
    return [plain.index(half) for half in (f"{wanted}left", f"{wanted}right") if half in plain]


def canonical_name(name):
    """`blendShape1.browOuterUp_L` -> `browOuterUpLeft`. Of an unknown shape, its name without prefix."""
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
