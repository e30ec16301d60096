"""Draws the creases of the hand as strokes: across the finger joints, and in the palm. They were designed by eye."""

import numpy as np

from .creases import Chart, document
from .hand import FINGERS, Hand, palm_frame

NAMES = {1: "thumb", 2: "index", 3: "middle", 4: "ring", 5: "little"}
MAP_SIZE = 2048  # width and height of the normal map, pixels; enough for lines of 1 mm

# Lines of the palm by area: points, width and depth, in millimetres. Points are in the frame of `palm_frame`, with the
# origin at the wrist.
PALM = {
    "palm": [
        ([(47, 77), (30, 79), (12, 86), (-3, 98), (-10, 110)], 3.0, 1.5),  # distal transverse
        ([(-38, 87), (-20, 83), (0, 73), (18, 60), (31, 47)], 2.8, 1.3),  # proximal transverse
        ([(39, 68), (30, 71), (20, 74)], 1.5, 0.4),
        ([(56, 86), (47, 85), (38, 87)], 2.2, 0.8),  # below the little finger, where a fist folds most
        ([(54, 71), (45, 70), (35, 73)], 2.0, 0.7),
        ([(24, 68), (12, 76), (4, 80)], 1.4, 0.35),
    ],
    "thenar": [
        ([(-38, 85), (-24, 80), (-9, 66), (-2, 48), (-3, 30), (-8, 14)], 3.0, 1.5),
        ([(-20, 62), (-12, 52), (-9, 40)], 1.5, 0.4),
        ([(-30, 64), (-20, 52), (-15, 38)], 1.4, 0.35),
    ],
}
# Lines across the inside of a finger, by number of the joint. A line is an arc. Its four values are in millimetres:
# distance of both ends from the joint, offset of the middle from the ends, width and depth. Distance and offset are
# along the finger, positive towards the tip.
FLEXION = {
    1: [(15.5, -1.0, 2.1, 0.80), (18.0, -0.5, 1.4, 0.40)],
    2: [(-1.0, -0.8, 2.1, 0.85), (1.6, 0.6, 1.8, 0.60)],
    3: [(-1.2, -0.6, 2.0, 0.80), (0.8, 0.4, 1.2, 0.35)],
}
# Lines across the back of a finger, in the same format. Bending smooths them.
EXTENSION = {
    2: [
        (-3.6, -1.6, 1.3, 0.24),
        (-2.0, -1.0, 1.4, 0.32),
        (-0.5, -0.3, 1.5, 0.36),
        (1.0, 0.5, 1.4, 0.32),
        (2.6, 1.3, 1.3, 0.24),
    ],
    3: [(-1.2, -0.5, 1.1, 0.20), (0.2, 0.0, 1.2, 0.24), (1.6, 0.5, 1.1, 0.18)],
}
# Half the length of a crease on the inside, millimetres. More than half a finger's width, because `Chart.stroke` cuts
# the crease at the region's edge.
REACH = 11.0
BACK_WIDTH = 0.55  # length of a crease on the back, as a fraction of the finger's width


def hand_strokes(hand: Hand) -> str:
    flat = (hand.part.positions - hand.rig.at("wrist.L")) @ palm_frame(hand.rig)[:, :2] * 1e3
    thumb = _finger_weight(hand, 1, 2) > 0.6
    palm = Chart(hand.part, flat, (hand.inner > -0.15) & ~thumb)
    strokes = [
        s
        for group, lines in PALM.items()
        for points, width, depth in lines
        for s in palm.stroke(group, points, width, depth, taper=0.35, softness=0.3, waviness=0.3)
    ]
    for finger in FINGERS:
        strokes += _finger(hand, finger)

    def feathered(name, radius, feather):
        return {
            "name": name,
            "shapes": [{"group": name, "radius": radius, "feather": feather}],
        }

    areas = [feathered(name, 3.5, 4) for name in NAMES.values()]
    areas += [feathered("knuckles", 3.5, 4), feathered("palm", 5, 6), feathered("thenar", 5, 6)]
    return document(strokes, areas, MAP_SIZE)


def _finger(hand: Hand, finger: int) -> list[dict]:
    strokes = []
    for k in (1, 2, 3):
        joint = hand.rig.names.index(f"finger{finger}-{k}.L")
        flat = (hand.part.positions - hand.rig.positions[joint]) @ hand.rig.frames[joint][:, :2] * 1e3
        on_finger = _finger_weight(hand, finger, max(1, k - 1)) > 0.4
        inside = Chart(hand.part, flat, on_finger & (hand.inner > 0.0))
        back = Chart(hand.part, flat, on_finger & (hand.inner < -0.1))
        # The first two joints of the thumb get no lines. They are in the ball of the thumb, where the palm has lines.
        for y, bow, width, depth in FLEXION[k] if finger > 1 or k > 2 else []:
            strokes += inside.stroke(
                NAMES[finger], _arc(y, bow, REACH), width, depth, taper=0.25, softness=0.3, waviness=0.25
            )
        size = _width(hand, finger, joint) * BACK_WIDTH
        for y, bow, width, depth in EXTENSION.get(k, []):
            strokes += back.stroke(
                "knuckles", _arc(y, bow, size), width, depth, taper=0.5, shoulder=0.9, softness=0.4, waviness=0.5
            )
    return strokes


def _arc(y: float, bow: float, reach: float) -> list[tuple[float, float]]:
    return [(x * reach, y + bow * (1 - x * x)) for x in np.linspace(-1, 1, 7)]


def _finger_weight(hand: Hand, finger: int, first: int) -> np.ndarray:
    """Returns, for each vertex (n,), the sum of the weights of a finger's joints from `first` to the last joint."""
    return hand.weights[:, [hand.rig.names.index(f"finger{finger}-{k}.L") for k in range(first, 4)]].sum(axis=1)


def _width(hand: Hand, finger: int, joint: int) -> float:
    """Returns half a finger's width at a joint, millimetres."""
    local = (hand.part.positions - hand.rig.positions[joint]) @ hand.rig.frames[joint] * 1e3
    ring = (np.abs(local[:, 1]) < 3) & (_finger_weight(hand, finger, 1) > 0.4)
    return np.abs(local[ring, 0]).max()
