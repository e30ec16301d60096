"""Warps a head to cartoon proportions: large eyes, short nose, small mouth, big skull, thin neck.

The warp depends only on a point's position, so that lids and lips still meet. With slightly larger strengths than the
maxima in `style_of`, it would fold the skin between the eyes.
"""

from dataclasses import dataclass

import numpy as np

from ..source import Mesh

# Radii of the features' warps, as fractions of the distance between the eyes.
EYE_SIZE, NOSE_SIZE, MOUTH_SIZE = 0.45, 0.27, 0.5
MOUTH_ALONG = np.array([1, 0.4, 0.4])


@dataclass
class Style:
    """Changes to a person's proportions. Fields are fractions of the original size unless stated otherwise."""

    eyes: float  # enlargement of the eyes
    apart: float  # shift of each eye outwards, as a fraction of the distance between the eyes
    wide: float  # weight of the target eyeWide
    nose: float  # reduction of the nose's length and depth
    mouth: float  # reduction of the mouth's width
    skull: float  # enlargement of the skull above the eyes
    jaw: float  # reduction of the jaw's width at the chin
    neck: float  # reduction of the neck's width


@dataclass
class Places:
    """Positions of a head's features at rest, metres."""

    eyes: np.ndarray  # (2, 3) centres
    nose: np.ndarray  # point behind the tip of the nose, in the plane of the face
    mouth: np.ndarray  # centre
    chin: float  # height
    neck: np.ndarray  # point on the neck's axis; only x and z are used


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
    """Finds the features of a head.

    `base`: vertices of the full figure at rest. `skin`: points on the head's skin, (n, 3).
    """

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
    # The head gets wider from the chin upwards.
    height = (out[:, 1] - places.chin) / (eye_line - places.chin)
    wide = 1 + style.skull * _step(height, 0.4, 1.6) - style.jaw * (1 - _step(height, -0.3, 0.9))
    wide *= 1 - style.neck * (1 - _step(height, -0.8, 0.1))
    # Scales x around the plane of symmetry, and z around the neck's axis. Above the eyes, the skull also grows upwards.
    axis = places.neck[2]
    out[:, 0] = places.mouth[0] + (out[:, 0] - places.mouth[0]) * wide
    deep = 1 + style.skull * _step(height, 0.7, 2) - style.neck * (1 - _step(height, -0.8, 0.1))
    out[:, 2] = axis + (out[:, 2] - axis) * deep
    rise = np.maximum(out[:, 1] - eye_line, 0)
    out[:, 1] += style.skull * rise * _step(rise, 0, 1.3 * apart)
    return out


def _bell(points, centre, size) -> np.ndarray:
    """Returns a Gaussian weight: 1 at `centre`, exp(-0.5) at the distance `size`."""
    return np.exp(-((points - centre) ** 2).sum(axis=1, keepdims=True) / (2 * size**2))


def _plateau(points, centre, size) -> np.ndarray:
    """Returns a weight that is nearly 1 over an eyeball, so that the scaled ball stays round."""
    return np.exp(-((((points - centre) ** 2).sum(axis=1, keepdims=True) / size**2) ** 2))


def _step(x, low, high):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)
