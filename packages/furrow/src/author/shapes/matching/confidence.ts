import { exp } from '../../../math/elementary.ts'
import { clamp } from '../../../math/scalar.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import type { FaceFrame } from '../landmarks/face-frame.ts'
import { FOUND, MAX_DIFFERENT, type Match, SAME } from './match.ts'

/** Minimum confidence of a shape that is recognised by its motion alone. */
export const UNSURE = 0.45
/** Minimum confidence at which a label found by motion overrules a contradicting name. */
export const SURE = 0.7

/** Number of labels in a complete ARKit set. */
const FULL_SET = 51

/** Plausible range of the eyes' height above the mouth, in units of half the distance between the eyes. Outside it, landmarks may be wrong. */
const HEIGHTS = [1.5, 3] as const

/**
 * Computes the confidence of each match of a blendshape and an ARKit label, 0..1. It is a logistic function of the match's score, its margin
 * to other labels, the motion outside the face, and doubt about the landmarks. A nearly complete ARKit set raises the confidence, because few
 * labels remain for each shape. The coefficients are fitted to heads from several sources, with complete and incomplete sets of shapes.
 */
export function confidencesOf(
  { shapes }: ShapeFields,
  matches: readonly Match[],
  frame: FaceFrame,
): number[] {
  const found = matches.filter(({ kinship, score }) => kinship === 1 && score > FOUND).length
  const fullness = clamp((found / FULL_SET - 0.6) / 0.3, 0, 1)
  const doubt = doubtOf(frame)
  return matches.map(({ shape, score, margin, kinship }) => {
    const evidence =
      6.8 * score + 20 * Math.min(margin, 0.08) + 7.5 * Math.min(margin, 0.3) - 5.3 * shapes[shape].outside
    const same = clamp((kinship - MAX_DIFFERENT) / (SAME - MAX_DIFFERENT), 0, 1)
    return 1 / (1 + exp(6.6 + doubt - evidence - 1.9 * same * fullness + 2.5 * (1 - same)))
  })
}

/**
 * Returns the doubt about the landmarks, 0..5. It is subtracted from the logit of the confidence. The mouth is guessed if no target opens the
 * lips. The eyes are guessed if no target closes lids.
 */
function doubtOf({ hasLids, seam, scales }: FaceFrame): number {
  if (!seam) return 5
  if (!hasLids) return 3
  const height = (2 * scales[0]) / scales[1]
  return height < HEIGHTS[0] || height > HEIGHTS[1] ? 2.5 : 0
}
