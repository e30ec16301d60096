"""Cartoon proportions as a map of space: large eyes, short nose, small mouth, big skull, thin neck.

The map depends only on a point's position, so that lids and lips still meet. With slightly larger strengths than the
maxima in `style_of`, the map would fold the skin between the eyes.
"""

from dataclasses import dataclass

import numpy as np

from ..source import Mesh

# Fractions of the distance between the eyes.
EYE_SIZE, NOSE_SIZE, MOUTH_SIZE = 0.45, 0.27, 0.5
MOUTH_ALONG = np.array([1, 0.4, 0.4])


@dataclass
class Style:
    """Strengths of a cartoon, 0..1 unless stated otherwise."""

    eyes: float  # growth
    apart: float  # fraction of the distance between the eyes that each moves outwards
    wide: float  # amount of eyeWide
    nose: float  # loss of length and depth
    mouth: float  # loss of width
    skull: float  # growth above the eyes
    jaw: float  # loss of width at the chin
    neck: float  # loss of width


@dataclass
class Places:
    """Centres of features at rest, metres."""

    eyes: np.ndarray  # (2, 3)
    nose: np.ndarray  # on the face behind the tip
    mouth: np.ndarray
    chin: float  # height
    neck: np.ndarray


def style_of(seed: int) -> Style:
    random = np.random.default_rng([seed, 3])
    return Style(
        eyes=random.uniform(0.42, 0.52),
        apart=random.uniform(0.065, 0.095),
        wide=random.uniform(0.5, 1.1),
        nose=random.uniform(0.5, 0.65),
        mouth=random.uniform(0.2, 0.4),
        skull=random.uniform(0.15, 0.3),
        jaw=random.uniform(0, 0.15),
        neck=random.uniform(0.35, 0.5),
    )


def places_of(mesh: Mesh, base: np.ndarray, skin: np.ndarray) -> Places:
    """Finds the features. `base`: vertices of the figure at rest; `skin`: points on the head's skin, (n, 3)."""

    def middle(group):
        points = base[np.unique(mesh.quads[mesh.groups == group])]
        return (points.min(axis=0) + points.max(axis=0)) / 2

    eyes = np.stack([middle("helper-l-eye"), middle("helper-r-eye")])
    teeth = base[np.unique(mesh.quads[np.isin(mesh.groups, ["helper-upper-teeth", "helper-lower-teeth"])])]
    mouth = np.array([eyes[:, 0].mean(), teeth[:, 1].mean(), teeth[:, 2].max()])
    central = skin[np.abs(skin[:, 0] - mouth[0]) < 0.02]
    between = central[(central[:, 1] > mouth[1] + 0.01) & (central[:, 1] < eyes[:, 1].mean())]
    tip = between[between[:, 2].argmax()]
    nose = np.array([mouth[0], 0.7 * tip[1] + 0.3 * eyes[:, 1].mean(), mouth[2]])
    below = central[(central[:, 1] < mouth[1]) & (central[:, 2] > mouth[2] - 0.02)]
    low = skin[skin[:, 1] < skin[:, 1].min() + 0.03]
    return Places(eyes, nose, mouth, below[:, 1].min(), np.array([mouth[0], 0, low[:, 2].mean()]))


def stylise(points: np.ndarray, places: Places, style: Style) -> np.ndarray:
    """Maps points, (n, 3)."""
    eye_line = places.eyes[:, 1].mean()
    apart = np.linalg.norm(places.eyes[0] - places.eyes[1])
    out = points.copy()
    grown = np.zeros_like(out)
    for eye in places.eyes:
        weight = _plateau(out, eye, apart * EYE_SIZE)
        outward = np.array([np.sign(eye[0] - places.nose[0]) * style.apart * apart, 0, 0])
        grown += weight * (style.eyes * (out - eye) + outward)
    out = out + grown
    out = out - style.nose * (out - places.nose) * _bell(out, places.nose, apart * NOSE_SIZE)
    out = out - style.mouth * (out - places.mouth) * MOUTH_ALONG * _bell(out, places.mouth, apart * MOUTH_SIZE)
    # The skull widens upwards from the chin, and rises above the eyes.
    height = (out[:, 1] - places.chin) / (eye_line - places.chin)
    wide = 1 + style.skull * _step(height, 0.4, 1.6) - style.jaw * (1 - _step(height, -0.3, 0.9))
    wide *= 1 - style.neck * (1 - _step(height, -0.8, 0.1))
    # Scales around the neck's axis in z, and around the middle plane in x.
    axis = places.neck[2]
    out[:, 0] = places.mouth[0] + (out[:, 0] - places.mouth[0]) * wide
    deep = 1 + style.skull * _step(height, 0.7, 2) - style.neck * (1 - _step(height, -0.8, 0.1))
    out[:, 2] = axis + (out[:, 2] - axis) * deep
    rise = np.maximum(out[:, 1] - eye_line, 0)
    out[:, 1] += style.skull * rise * _step(rise, 0, 1.3 * apart)
    return out


def _bell(points, centre, size) -> np.ndarray:
    """Computes a Gaussian weight. Scaling around `centre` with this weight folds the skin only if the scale is 0."""
    return np.exp(-((points - centre) ** 2).sum(axis=1, keepdims=True) / (2 * size**2))


def _plateau(points, centre, size) -> np.ndarray:
    """Weight of nearly 1 over an eyeball, so that the ball stays round."""
    return np.exp(-((((points - centre) ** 2).sum(axis=1, keepdims=True) / size**2) ** 2))


def _step(x, low, high):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
