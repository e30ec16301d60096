"""Chooses random weights of MakeHuman's identity targets, the morph targets that make different people."""

import numpy as np

# Pairs of opposite targets, such as smaller and larger. For example, "head/head-" with "age:decr:incr" means the two
# targets head/head-age-decr and head/head-age-incr. Targets that move a feature sideways are omitted.
PAIRS = {
    "head/head-": ["age:decr:incr", "fat:decr:incr", "angle:in:out", "back-scale-depth:decr:incr"],
    "head/head-scale-": ["depth:decr:incr", "horiz:decr:incr", "vert:decr:incr"],
    "forehead/forehead-": ["nubian:decr:incr", "scale-vert:decr:incr", "temple:decr:incr", "trans:backward:forward"],
    "eyebrows/eyebrows-": ["angle:down:up", "trans:backward:forward", "trans:down:up"],
    "nose/nose-": [
        "base:down:up",
        "compression:compress:uncompress",
        "curve:concave:convex",
        "flaring:decr:incr",
        "greek:decr:incr",
        "hump:decr:incr",
        "nostrils-angle:down:up",
        "nostrils-width:decr:incr",
        "point:down:up",
        "point-width:decr:incr",
        "scale-depth:decr:incr",
        "scale-horiz:decr:incr",
        "scale-vert:decr:incr",
        "septumangle:decr:incr",
        "trans:backward:forward",
        "trans:down:up",
        "volume:decr:incr",
        "width1:decr:incr",
        "width2:decr:incr",
        "width3:decr:incr",
    ],
    "mouth/mouth-": [
        "angles:down:up",
        "cupidsbow:decr:incr",
        "cupidsbow-width:decr:incr",
        "dimples:in:out",
        "laugh-lines:in:out",
        "lowerlip-height:decr:incr",
        "lowerlip-volume:decr:incr",
        "lowerlip-width:decr:incr",
        "philtrum-volume:decr:incr",
        "scale-depth:decr:incr",
        "scale-horiz:decr:incr",
        "scale-vert:decr:incr",
        "trans:backward:forward",
        "trans:down:up",
        "upperlip-height:decr:incr",
        "upperlip-volume:decr:incr",
        "upperlip-width:decr:incr",
    ],
    "chin/chin-": [
        "bones:decr:incr",
        "cleft:decr:incr",
        "height:decr:incr",
        "jaw-drop:decr:incr",
        "prognathism:decr:incr",
        "prominent:decr:incr",
        "width:decr:incr",
    ],
    "neck/neck-": ["double:decr:incr", "scale-depth:decr:incr", "scale-horiz:decr:incr"],
}
# Pairs of opposite targets that exist for the left and the right side. `?` is replaced by l or r.
SIDED_PAIRS = {
    "cheek/?-cheek-": ["bones:decr:incr", "inner:decr:incr", "trans:down:up", "volume:decr:incr"],
    "eyes/?-eye-": [
        "bag:decr:incr",
        "bag:in:out",
        "bag-height:decr:incr",
        "corner1:down:up",
        "corner2:down:up",
        "epicanthus:in:out",
        "eyefold:concave:convex",
        "eyefold:down:up",
        "eyefold-angle:down:up",
        "height1:decr:incr",
        "height2:decr:incr",
        "height3:decr:incr",
        "scale:decr:incr",
        "trans:down:up",
        "trans:in:out",
    ],
    "ears/?-ear-": [
        "flap:decr:incr",
        "lobe:decr:incr",
        "rot:backward:forward",
        "scale:decr:incr",
        "scale-vert:decr:incr",
        "wing:decr:incr",
    ],
}
SKULL = ("head/head-", "head/head-scale-", "forehead/forehead-", "neck/neck-")
OUTLINES = ["diamond", "invertedtriangular", "oval", "rectangular", "round", "square", "triangular"]
UNEVEN = [
    "brown-1",
    "brown-2",
    "cheek-1",
    "cheek-2",
    "eye-1",
    "eye-3",
    "jaw-1",
    "jaw-2",
    "mouth-1",
    "mouth-2",
    "nose-1",
]

# Each pair has one random weight. If it is positive, it applies to the second target, otherwise to the first.
SPREAD = 0.25  # standard deviation of a pair's weight
SKULL_SPREAD = 0.15  # standard deviation for pairs in `SKULL`, whose targets are stronger
MAX_AMOUNT = 0.8  # maximum weight of a target
UNEVENNESS = 0.04  # standard deviation of the random weight that each side adds to the weight of both sides
CHILDREN = 0.1  # fraction of heads with childlike features


def identity(seed: int) -> dict[str, float]:
    """Returns the weights of a random person's targets, 0..1, by target name. The same seed gives the same person."""
    random = np.random.default_rng([seed, 1])
    amounts = _people(random)
    for family, pairs in PAIRS.items():
        for pair in pairs:
            _add(amounts, family, pair, random.normal(0, SKULL_SPREAD if family in SKULL else SPREAD))
    for family, pairs in SIDED_PAIRS.items():
        for pair in pairs:
            both = random.normal(0, SPREAD)
            for side in "lr":
                _add(amounts, family.replace("?", side), pair, both + random.normal(0, UNEVENNESS))
    amounts["head/head-" + random.choice(OUTLINES)] = random.uniform(0, 0.4)
    for name in random.choice(UNEVEN, size=3, replace=False):
        amounts[f"asym/asym-{name}-{random.choice(['l', 'r'])}"] = random.uniform(0.05, 0.3)
    return {name: float(round(amount, 4)) for name, amount in amounts.items() if round(amount, 4) > 0}


def _people(random: np.random.Generator) -> dict[str, float]:
    """Chooses weights of the targets for ancestry, sex, age, muscle and body weight.

    A person can, for example, be 30 per cent male and 70 per cent old. The weight of a target is the product of these
    shares, over all properties in the target's name.
    """
    ancestry = dict(zip(["african", "asian", "caucasian"], random.dirichlet([0.7] * 3), strict=True))
    male = random.beta(0.4, 0.4)
    old = random.uniform(0, 1)
    child = random.uniform(0.2, 0.6) if random.random() < CHILDREN else 0.0
    ages = {"child": child, "old": (1 - child) * old, "young": (1 - child) * (1 - old)}
    muscle, weight = (_three(random.triangular(-1, 0, 1)) for _ in range(2))
    amounts = {}
    for sex, of_sex in (("female", 1 - male), ("male", male)):
        for age, of_age in ages.items():
            for people, share in ancestry.items():
                amounts[f"macrodetails/{people}-{sex}-{age}"] = of_sex * of_age * share
            for m, of_muscle in muscle.items():
                for w, of_weight in weight.items():
                    name = f"macrodetails/universal-{sex}-{age}-{m}muscle-{w}weight"
                    amounts[name] = of_sex * of_age * of_muscle * of_weight
    return amounts


def _three(value: float) -> dict[str, float]:
    """Splits a value in -1..1 into shares of the minimum, average and maximum target. The shares sum to 1."""
    return {"min": max(0, -value), "average": 1 - abs(value), "max": max(0, value)}


def _add(amounts: dict[str, float], family: str, pair: str, amount: float) -> None:
    name, low, high = pair.split(":")
    amounts[f"{family}{name}-{high if amount > 0 else low}"] = min(abs(amount), MAX_AMOUNT)
