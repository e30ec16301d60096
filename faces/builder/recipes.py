"""Lists the recipes of people: weights of MakeHuman's targets (`shapes`), and colours and other values (`look`).

Colours are sRGB, 0..1, unless stated otherwise. Lengths are in uv.
"""

HUMAN = {
    "file": "human.glb",
    "shapes": {
        "macrodetails/caucasian-male-young": 0.3,
        "macrodetails/caucasian-male-old": 0.7,
        "macrodetails/universal-male-young-averagemuscle-averageweight": 0.3,
        "macrodetails/universal-male-old-averagemuscle-averageweight": 0.7,
        "nose/nose-hump-incr": 0.25,
        "nose/nose-point-width-incr": 0.25,
        "chin/chin-cleft-incr": 0.3,
        "head/head-age-incr": 0.35,
        "mouth/mouth-lowerlip-volume-incr": 0.25,
        "mouth/mouth-upperlip-volume-incr": 0.35,
        "ears/l-ear-wing-decr": 0.2,
        "ears/r-ear-wing-decr": 0.2,
        "asym/asym-nose-1-l": 0.25,
        "asym/asym-mouth-1-r": 0.25,
        "asym/asym-brown-1-l": 0.3,
        "asym/asym-jaw-1-r": 0.25,
    },
    # Weights of expressions in the resting face, by ARKit name.
    "rest": {
        "eyeWideLeft": 0.32,
        "eyeWideRight": 0.32,
        "browDownLeft": 0.22,
        "browDownRight": 0.26,
        "mouthClose": 0.06,
        "mouthSmileLeft": 0.13,
        "mouthSmileRight": 0.11,
    },
    "look": {
        "seed": 8,
        "skin": (0.800, 0.625, 0.535),
        "mottle": 0.030,
        "blood": (0.735, 0.440, 0.375),
        "redness": 0.34,
        "pale": (0.83, 0.68, 0.57),
        "lid": (0.660, 0.455, 0.400),
        "tired": 0.52,
        "rim": (0.74, 0.47, 0.42),
        "freckle": (0.58, 0.40, 0.31),
        "freckles": 0.35,
        "fold": 0.42,
        "lip": (0.690, 0.435, 0.390),
        "lips": 0.78,
        "lip_line": (0.42, 0.20, 0.18),
        "beard": 0.30,
        "beard_colour": (0.50, 0.42, 0.38),
        "hair": (0.215, 0.175, 0.150),
        "hair_grey": (0.50, 0.46, 0.43),
        "grey": 0.5,
        "hair_cover": 0.78,
        "hair_softness": 0.012,
        "thinning": 0.45,
        "brow": (0.265, 0.210, 0.172),
        "brow_hairs": 430,
        "brow_width": 0.9,
        "brow_length": 0.026,
        "brow_thick": 3.6,
        "lash": (0.09, 0.065, 0.05),
        "lashes": 140,
        "lash_length": 0.8,
        "iris": (0.30, 0.37, 0.40),
        "iris_inner": (0.44, 0.38, 0.26),
        "eye_white": (0.80, 0.765, 0.725),
        "roughness": 0.60,
        "pores": 0.55,
        "fuzz": (0.030, 0.018, 0.014),  # linear
        "shirt": (0.020, 0.024, 0.032),  # linear
    },
}

HUMAN_2 = {
    "file": "human-2.glb",
    "shapes": {
        "macrodetails/african-female-young": 0.25,
        "macrodetails/african-female-old": 0.75,
        "macrodetails/universal-female-young-averagemuscle-averageweight": 0.25,
        "macrodetails/universal-female-old-averagemuscle-averageweight": 0.75,
        "head/head-oval": 0.3,
        "cheek/l-cheek-bones-incr": 0.35,
        "cheek/r-cheek-bones-incr": 0.35,
        "asym/asym-nose-2-r": 0.2,
        "asym/asym-mouth-2-l": 0.2,
        "asym/asym-brown-2-r": 0.25,
        "asym/asym-jaw-2-l": 0.2,
    },
    "rest": {
        "eyeWideLeft": 0.32,
        "eyeWideRight": 0.32,
        "mouthClose": 0.05,
        "mouthSmileLeft": 0.08,
        "mouthSmileRight": 0.09,
    },
    "look": {
        "seed": 21,
        "skin": (0.470, 0.325, 0.262),
        "mottle": 0.034,
        "blood": (0.470, 0.255, 0.200),
        "redness": 0.38,
        "pale": (0.57, 0.40, 0.30),
        "lid": (0.350, 0.220, 0.180),
        "tired": 0.42,
        "rim": (0.40, 0.22, 0.19),
        "freckle": (0.26, 0.16, 0.12),
        "freckles": 0.35,
        "fold": 0.45,
        "lip": (0.450, 0.235, 0.215),
        "lips": 0.72,
        "lip_line": (0.20, 0.09, 0.08),
        "beard": 0.0,
        "beard_colour": (0.0, 0.0, 0.0),
        "hair": (0.085, 0.070, 0.065),
        "hair_grey": (0.42, 0.40, 0.39),
        "grey": 0.40,
        "hair_cover": 0.90,
        "hair_softness": 0.010,
        "thinning": 0.1,
        "brow": (0.105, 0.080, 0.070),
        "brow_hairs": 330,
        "brow_width": 0.62,
        "brow_length": 0.022,
        "brow_thick": 3.3,
        "lash": (0.04, 0.03, 0.03),
        "lashes": 190,
        "lash_length": 0.95,
        "iris": (0.20, 0.115, 0.065),
        "iris_inner": (0.27, 0.165, 0.09),
        "eye_white": (0.72, 0.67, 0.61),
        "roughness": 0.54,
        "pores": 0.50,
        "fuzz": (0.020, 0.013, 0.010),  # linear
        "shirt": (0.055, 0.018, 0.022),  # linear
    },
}

RECIPES = [HUMAN, HUMAN_2]

# The hand belongs to the person of human.glb.
HAND = {
    "shapes": HUMAN["shapes"],
    "look": HUMAN["look"]
    | {
        "seed": 5,
        "skin": (0.770, 0.585, 0.490),
        "blood": (0.735, 0.420, 0.350),
        "palm": (0.840, 0.640, 0.565),
        "nail": (0.820, 0.605, 0.545),
        "nail_edge": (0.890, 0.835, 0.775),
        "pores": 0.12,
        "roughness": 0.56,
    },
}

# The clothed figure is the person of human.glb. Colours of clothes are linear.
FIGURE = {
    "shapes": {
        name: amount
        for name, amount in HUMAN["shapes"].items()
        if name.startswith(("macrodetails", "nose", "chin", "head", "mouth", "ears"))
    },
    "clothes": {
        "shirt-cotton": (0.33, 0.40, 0.46),
        "trousers-denim": (0.105, 0.140, 0.205),
        "shoes": (0.030, 0.022, 0.018),
    },
}
