import type { Hinge } from '../skeleton/bone-names.ts'
import type { ArcCrease } from './hand-tables.ts'

/** Creases of a hinge: in the crook, which bending deepens, and on the other side, which bending smooths. */
export interface HingeCreases {
  crook: readonly ArcCrease[]
  back: readonly ArcCrease[]
  /** Maximum depths in millimetres at 20 years. */
  depth: { crook: number; back: number }
  /** Sum of the lengths of both halves of the limb for which the distances are, in millimetres. */
  length: number
}

/**
 * Creases of elbows and knees of an adult. The front of the elbow has one or two flexion creases slightly above the joint line, and the back of
 * the knee one or two at the joint line. The loose skin over the tip of a straight elbow and over the kneecap of a straight knee lies in short
 * wrinkles across the limb.
 */
export const HINGE_CREASES: Readonly<Record<Hinge, HingeCreases>> = {
  elbow: {
    crook: [
      { along: -5, bow: 3.5, span: 1.05, width: 3.6, depth: 1 },
      { along: -15, bow: 2, span: 0.75, width: 3.2, depth: 0.55 },
      { along: 8, bow: 1.5, span: 0.5, width: 2.8, depth: 0.3 },
    ],
    back: [
      { along: -15, bow: -3.6, span: 0.4, width: 4, depth: 0.45 },
      { along: -8, bow: -2.8, span: 0.62, width: 4.4, depth: 0.8 },
      { along: -1, bow: -1.2, span: 0.78, width: 4.8, depth: 1 },
      { along: 6, bow: 0.8, span: 0.74, width: 4.6, depth: 0.9 },
      { along: 13, bow: 2.4, span: 0.56, width: 4.2, depth: 0.6 },
      { along: 20, bow: 3.2, span: 0.36, width: 3.8, depth: 0.4 },
    ],
    depth: { crook: 1.3, back: 0.65 },
    length: 540,
  },
  knee: {
    crook: [
      { along: -4, bow: -4, span: 0.85, width: 4.4, depth: 1 },
      { along: -17, bow: -2.5, span: 0.62, width: 3.8, depth: 0.5 },
      { along: 11, bow: -2, span: 0.5, width: 3.4, depth: 0.3 },
    ],
    back: [
      { along: -40, bow: -6, span: 0.45, width: 5, depth: 0.5 },
      { along: -28, bow: -5, span: 0.6, width: 5.6, depth: 0.9 },
      { along: -16, bow: -2.5, span: 0.52, width: 5.2, depth: 0.7 },
      { along: 13, bow: 5, span: 0.52, width: 5.2, depth: 0.8 },
      { along: 25, bow: 6, span: 0.4, width: 4.8, depth: 0.5 },
    ],
    depth: { crook: 1.5, back: 0.6 },
    length: 860,
  },
}
