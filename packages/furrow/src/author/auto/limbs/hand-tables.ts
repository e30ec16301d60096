import type { LimbPoint } from './limb-chart.ts'

/** Crease across a finger or an arm: an arc in the cylinder around the bone. */
export interface ArcCrease {
  /** Distance of the ends from the joint along the bone, in millimetres; positive towards the tip. */
  along: number
  /** Distance by which the middle lies beyond the ends, in millimetres. */
  bow: number
  /** Half of the angle that the crease spans, in radians. */
  span: number
  /** Width in millimetres. */
  width: number
  /** Depth relative to the deepest crease of the region, 0..1. */
  depth: number
}

/**
 * Flexion creases on the inside of the fingers. Most people have two at the middle joint, one at the last joint, and one or two at the base of
 * the finger (Kaplan's surgical anatomy of the hand). The middle crease lies over its joint, the last one slightly above its joint, and the
 * crease at the base about halfway between the first two joints.
 */
export const FINGER_CREASES = {
  base: [
    { along: -0.6, bow: -1.2, span: 1.25, width: 2.3, depth: 1 },
    { along: 2.2, bow: -0.6, span: 1.0, width: 1.6, depth: 0.55 },
  ],
  middle: [
    { along: -1.1, bow: -0.9, span: 1.4, width: 2.2, depth: 1 },
    { along: 1.5, bow: 0.7, span: 1.3, width: 1.9, depth: 0.8 },
    { along: -4.2, bow: -0.8, span: 0.8, width: 1.3, depth: 0.3 },
  ],
  last: [
    { along: -1.3, bow: -0.7, span: 1.35, width: 2.1, depth: 1 },
    { along: 0.9, bow: 0.4, span: 0.9, width: 1.3, depth: 0.4 },
  ],
  thumb: [
    { along: -1.0, bow: -0.8, span: 1.3, width: 2.4, depth: 1 },
    { along: 1.6, bow: 0.5, span: 1.1, width: 1.7, depth: 0.6 },
  ],
  thumbBase: [
    { along: 1.0, bow: -0.7, span: 0.8, width: 2.1, depth: 0.8 },
    { along: 4.4, bow: -0.4, span: 0.6, width: 1.5, depth: 0.4 },
  ],
} as const satisfies Record<string, readonly ArcCrease[]>

/** Lines on the back of the finger joints: an oval of arcs that bow away from its middle. Bending smooths them. */
export const KNUCKLE_LINES = {
  middle: [
    { along: -5.2, bow: -1.1, span: 0.8, width: 1.3, depth: 0.5 },
    { along: -3.5, bow: -0.9, span: 1.15, width: 1.4, depth: 0.8 },
    { along: -1.8, bow: -0.6, span: 1.35, width: 1.5, depth: 1 },
    { along: -0.1, bow: -0.1, span: 1.4, width: 1.5, depth: 0.9 },
    { along: 1.6, bow: 0.4, span: 1.35, width: 1.5, depth: 1 },
    { along: 3.3, bow: 0.8, span: 1.1, width: 1.4, depth: 0.75 },
    { along: 5.0, bow: 1.0, span: 0.7, width: 1.3, depth: 0.45 },
  ],
  last: [
    { along: -2.6, bow: -0.5, span: 1.0, width: 1.2, depth: 0.7 },
    { along: -1.0, bow: -0.3, span: 1.25, width: 1.3, depth: 1 },
    { along: 0.6, bow: 0.1, span: 1.2, width: 1.3, depth: 0.85 },
    { along: 2.2, bow: 0.4, span: 0.85, width: 1.2, depth: 0.5 },
  ],
} as const satisfies Record<string, readonly ArcCrease[]>

/** Creases inside the wrist and on its back. Distances are for an adult arm. */
export const WRIST_CREASES = {
  inside: [
    { along: 1, bow: 1.2, span: 1.15, width: 2.6, depth: 1 },
    { along: -6.5, bow: 0.8, span: 1.0, width: 2.2, depth: 0.65 },
    { along: -12, bow: -0.6, span: 0.7, width: 1.8, depth: 0.35 },
  ],
  back: [
    { along: -7, bow: -1.2, span: 0.7, width: 2.0, depth: 0.55 },
    { along: -2.5, bow: -0.6, span: 0.95, width: 2.2, depth: 0.9 },
    { along: 2, bow: 0.6, span: 0.95, width: 2.2, depth: 1 },
    { along: 6.5, bow: 1.4, span: 0.75, width: 2.0, depth: 0.6 },
  ],
} as const satisfies Record<string, readonly ArcCrease[]>

/** Crease of the palm. */
export interface PalmCrease {
  /** Points in the frame of the hand, in millimetres for `REFERENCE_HAND`: towards the little finger, and from the wrist to the fingers. */
  points: readonly LimbPoint[]
  width: number
  depth: number
}

/** The three main creases of the palm, with short ones beside them, which differ from hand to hand. The names are those of anatomy. */
export const PALM_CREASES = {
  distal: [
    {
      points: [
        [46, 77],
        [30, 79],
        [12, 86],
        [-3, 98],
        [-10, 110],
      ],
      width: 3.2,
      depth: 1,
    },
    {
      points: [
        [55, 86],
        [47, 85],
        [38, 87],
      ],
      width: 2.2,
      depth: 0.6,
    },
    {
      points: [
        [24, 68],
        [12, 76],
        [4, 80],
      ],
      width: 1.6,
      depth: 0.42,
    },
    {
      points: [
        [35, 92],
        [29, 80],
        [27, 66],
      ],
      width: 1.3,
      depth: 0.24,
    },
    {
      points: [
        [15, 98],
        [12, 86],
        [14, 70],
      ],
      width: 1.3,
      depth: 0.26,
    },
    {
      points: [
        [0, 106],
        [8, 102],
        [20, 101],
      ],
      width: 1.4,
      depth: 0.28,
    },
  ],
  proximal: [
    {
      points: [
        [-38, 87],
        [-20, 83],
        [0, 73],
        [18, 60],
        [31, 47],
      ],
      width: 3,
      depth: 0.9,
    },
    {
      points: [
        [39, 68],
        [30, 71],
        [20, 74],
      ],
      width: 1.6,
      depth: 0.42,
    },
    {
      points: [
        [52, 70],
        [44, 69],
        [35, 72],
      ],
      width: 2,
      depth: 0.5,
    },
    {
      points: [
        [-22, 92],
        [-14, 87],
        [-4, 84],
      ],
      width: 1.4,
      depth: 0.28,
    },
    {
      points: [
        [38, 56],
        [28, 46],
        [19, 32],
      ],
      width: 1.4,
      depth: 0.28,
    },
    {
      points: [
        [45, 48],
        [35, 39],
        [28, 26],
      ],
      width: 1.3,
      depth: 0.24,
    },
    {
      points: [
        [8, 60],
        [5, 47],
        [7, 34],
      ],
      width: 1.4,
      depth: 0.3,
    },
  ],
  thenar: [
    {
      points: [
        [-38, 85],
        [-24, 80],
        [-10, 67],
        [-3, 50],
        [-3, 35],
        [-7, 24],
      ],
      width: 3.1,
      depth: 0.95,
    },
    {
      points: [
        [-24, 63],
        [-16, 52],
        [-13, 38],
        [-16, 26],
      ],
      width: 1.6,
      depth: 0.36,
    },
    {
      points: [
        [-32, 66],
        [-25, 54],
        [-21, 38],
      ],
      width: 1.5,
      depth: 0.3,
    },
    {
      points: [
        [-30, 76],
        [-20, 69],
        [-9, 66],
      ],
      width: 1.3,
      depth: 0.24,
    },
  ],
} as const satisfies Record<string, readonly PalmCrease[]>
