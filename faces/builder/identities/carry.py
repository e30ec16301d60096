"""Transfers expressions from MakeHuman's base figure to another person, and varies them as if other artists made them.

An expression is a morph target of the face with an ARKit name.
"""

import numpy as np
from scipy.spatial import cKDTree

# For these expressions, the rest position and the moved position of a vertex are transferred, so that lids still meet
# on larger eyes. For other expressions, a local affine map transforms the displacement.
LIDS = ("eyeBlink", "eyeLook", "eyeSquint", "eyeWide")
NEIGHBOURS = 24  # number of vertices to which a local affine map is fitted
STIFFNESS = 0.15  # regularisation of the fit towards the identity matrix, relative to the neighbours' variance
NEAR = 6  # number of vertices from which a displacement is interpolated

# Some artists mix a related expression into an expression of the same side. Each entry has three parts: the expression,
# the related expression, and the maximum weight of the related expression.
ACCENTS = [
    ("mouthSmile", "cheekSquint", 0.25),
    ("mouthSmile", "mouthDimple", 0.15),
    ("browDown", "noseSneer", 0.15),
    ("eyeSquint", "cheekSquint", 0.3),
    ("noseSneer", "mouthUpperUp", 0.25),
    ("mouthUpperUp", "noseSneer", 0.2),
    ("mouthFrown", "mouthStretch", 0.2),
    ("mouthStretch", "mouthLowerDown", 0.15),
    ("mouthPucker", "mouthFunnel", 0.2),
    ("cheekSquint", "eyeSquint", 0.2),
]
# Expressions that are not varied, because lids and lips must meet and eyes turn rigidly.
FIXED = ("eyeBlink", "eyeLook", "jawOpen", "mouthClose", "tongueOut")
STRENGTH = 0.2  # standard deviation of the logarithm of an expression's strength
STRENGTHS = (0.65, 1.2)  # minimum and maximum strength
SIDES = 0.05  # standard deviation of the logarithm of an additional factor for each side
WAVE = 0.12  # maximum local change of an expression's strength, as a fraction
WAVELENGTH = (0.06, 0.14)  # metres


def carry(
    units: dict[str, np.ndarray], source: np.ndarray, person: np.ndarray, used: np.ndarray
) -> dict[str, np.ndarray]:
    """Transfers expressions from the figure `source` to `person`.

    All arrays are (n, 3), over the vertices of the full figure. `units`: displacements by expression. `used`: indices
    of the vertices to transfer. The displacements of other vertices become 0.
    """
    moved = person - source
    tree = cKDTree(source[used])
    local = _local(source[used], person[used], tree)
    carried = {}
    for name, unit in units.items():
        shift = np.zeros_like(unit)
        moving = used[np.abs(unit[used]).max(axis=1) > 0]
        rows = np.searchsorted(used, moving)
        if name.startswith(LIDS):
            start, end = (_field(tree, moved[used], source[moving] + k * unit[moving]) for k in (0, 1))
            shift[moving] = unit[moving] + end - start
        else:
            shift[moving] = np.einsum("nij,nj->ni", local[rows], unit[moving])
        carried[name] = shift
    return carried


def vary(units: dict[str, np.ndarray], positions: np.ndarray, random: np.random.Generator) -> dict[str, np.ndarray]:
    """Varies expressions: scales them, mixes related expressions into them, and changes their strength locally."""
    shares = {(name, other): random.uniform(0, largest) for name, other, largest in ACCENTS}
    strengths = {stem: np.exp(random.normal(0, STRENGTH)) for stem in sorted({_stem(name) for name in units})}
    varied = {}
    for name, unit in units.items():
        stem = _stem(name)
        if stem.startswith(FIXED):
            varied[name] = unit
            continue
        mixed = unit.copy()
        for (first, other), share in shares.items():
            if first == stem:
                mixed += share * units[other + name[len(stem) :] if other + name[len(stem) :] in units else other]
        waves = np.ones(len(positions))
        for _ in range(3):
            direction = random.normal(size=3)
            direction *= 2 * np.pi / random.uniform(*WAVELENGTH) / np.linalg.norm(direction)
            waves += WAVE / 3 * np.sin(positions @ direction + random.uniform(0, 2 * np.pi))
        strength = np.clip(strengths[stem], *STRENGTHS) * np.exp(random.normal(0, SIDES))
        varied[name] = mixed * (strength * waves)[:, None]
    return varied


def _stem(name: str) -> str:
    return name.removesuffix("Left").removesuffix("Right")


def _local(source: np.ndarray, person: np.ndarray, tree: cKDTree) -> np.ndarray:
    """Fits an affine map to each vertex's neighbourhood by least squares, (n, 3, 3)."""
    _, near = tree.query(source, k=NEIGHBOURS)
    before = source[near] - source[near].mean(axis=1, keepdims=True)
    after = person[near] - person[near].mean(axis=1, keepdims=True)
    gram = np.einsum("nki,nkj->nij", before, before)
    cross = np.einsum("nki,nkj->nij", after, before)
    pull = STIFFNESS * np.trace(gram, axis1=1, axis2=2)[:, None, None] * np.eye(3)
    return (cross + pull) @ np.linalg.inv(gram + pull)


def _field(tree: cKDTree, moved: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Interpolates the displacements `moved` at `points` (n, 3). The weight of a vertex is 1 / squared distance."""
    distance, near = tree.query(points, k=NEAR)
    weight = 1 / (distance + 1e-3) ** 2
    return np.einsum("nk,nki->ni", weight / weight.sum(axis=1, keepdims=True), moved[near])
