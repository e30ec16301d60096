"""Transfers expressions from MakeHuman's base figure to a person, and varies them as artists would."""

import numpy as np
from scipy.spatial import cKDTree

# These shapes warp the space around the skin, so that lids still meet on larger eyes.
LIDS = ("eyeBlink", "eyeLook", "eyeSquint", "eyeWide")
NEIGHBOURS = 24  # vertices per fit of a local deformation
STIFFNESS = 0.15  # regularisation of the fit towards the identity, relative to the spread of the neighbours
NEAR = 6  # vertices to interpolate a displacement from

# Shapes that some artists mix into other shapes of the same side, with the maximum amount.
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
# These shapes are not varied: lids and lips must meet, and eyes turn rigidly.
FIXED = ("eyeBlink", "eyeLook", "jawOpen", "mouthClose", "tongueOut")
STRENGTH = 0.2  # standard deviation of the logarithm of a shape's strength
STRENGTHS = (0.65, 1.2)
SIDES = 0.05  # the same per side
WAVE = 0.12  # maximum local change of a shape's strength
WAVELENGTH = (0.06, 0.14)  # metres


def carry(
    units: dict[str, np.ndarray], source: np.ndarray, person: np.ndarray, used: np.ndarray
) -> dict[str, np.ndarray]:
    """Transfers the displacements `units` by the deformation from the figure `source` to `person`.

    All arrays are (n, 3) over the full figure. `used`: vertices to transfer; other displacements are 0.
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
    """Varies the shapes as another artist would: strengths, related shapes mixed in, local differences."""
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
    """Interpolates displacements at `points` (n, 3) from the nearest vertices, weighted by distance."""
    distance, near = tree.query(points, k=NEAR)
    weight = 1 / (distance + 1e-3) ** 2
    return np.einsum("nk,nki->ni", weight / weight.sum(axis=1, keepdims=True), moved[near])
