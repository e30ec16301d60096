"""Draws the creases of the neck as strokes: on both sides for turns of the head, and in front for nods."""

import numpy as np

from .creases import Chart, document
from .neck import Neck

AXIS = 0.030  # z of the neck's axis, metres
TOP = 0.735  # maximum height of the neck, metres
MAP_SIZE = 1024  # width and height of the normal map, pixels

# Each line has points, a width and a depth, both in millimetres. A point is an angle around the neck, in degrees, and a
# height in millimetres. The angle is 0 at the middle of the throat, and increases towards the person's left. If the
# head turns left, the skin folds along the lines in `SIDE`. The lines of the right side are their mirror images.
SIDE = [
    ([(14, 650), (27, 660), (41, 674), (52, 689)], 3.2, 0.9),
    ([(24, 647), (38, 657), (53, 672), (66, 691)], 3.6, 1.2),
    ([(36, 646), (50, 655), (66, 672), (79, 694)], 3.4, 1.1),
    ([(49, 647), (62, 655), (78, 671), (92, 692)], 3.2, 0.9),
    ([(63, 653), (77, 662), (91, 675), (103, 691)], 2.8, 0.6),
    ([(33, 653), (45, 663), (56, 676)], 2.0, 0.35),
    ([(46, 653), (57, 662), (69, 677)], 2.0, 0.35),
]
FRONT = [
    ([(-46, 652), (-24, 644), (0, 641), (25, 645), (44, 651)], 3.2, 1.0),
    ([(-52, 662), (-27, 654), (0, 651), (26, 653), (50, 663)], 3.6, 1.2),
    ([(-44, 671), (-22, 664), (0, 661), (24, 664), (46, 670)], 3.2, 1.0),
    ([(-30, 648), (-12, 646), (4, 647)], 2.0, 0.35),
    ([(2, 656), (16, 657), (30, 659)], 2.0, 0.35),
]


def neck_strokes(neck: Neck) -> str:
    """Returns the strokes document. Call after `spread_out`."""
    x, y, z = neck.skin.positions.T
    flat = np.stack([np.degrees(np.arctan2(x, z - AXIS)), y * 1e3], axis=1)
    chart = Chart(neck.skin, flat, (y < TOP) & (np.abs(flat[:, 0]) < 150))
    mirrored = [([(-x, y) for x, y in points], width, depth) for points, width, depth in SIDE]
    groups = {"neckLeft": SIDE, "neckRight": mirrored, "neckFront": FRONT}
    strokes = [
        stroke
        for group, lines in groups.items()
        for points, width, depth in lines
        for stroke in chart.stroke(group, points, width, depth, taper=0.45, shoulder=0.9, softness=0.35, waviness=0.35)
    ]
    areas = [{"name": name, "shapes": [{"group": name, "radius": 6, "feather": 8}]} for name in groups]
    return document(strokes, areas, MAP_SIZE)
