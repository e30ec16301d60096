import { exp } from '../../../math/elementary.ts'
import { clamp } from '../../../math/scalar.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'
import type { FaceFrame } from '../landmarks/face-frame.ts'
import { FOUND, type Match, SAME, UNLIKE } from './match.ts'

/** Confidence below which a shape is unknown. */
export const UNSURE = 0.45
/** Confidence from which on a shape overrules its name. */
export const SURE = 0.7

/** Labels of a full set of ARKit's. */
const FULL_SET = 51

/** Height of the eyes above the mouth, in half distances of the eyes: beyond these, lids or lips are likely mistaken for others. */
const HEIGHTS = [1.5, 3] as const

/**
 * The confidence of each match, 0..1: a logistic function of its score, its margin to other labels, the motion beyond the face and doubt about the
 * landmarks. The share of ARKit's set that is there counts too, since shapes of a full set decide each other's labels. The weights are fitted to
 * heads of several families, to parts of their sets, and to proportions, compositions and corrections of them.
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
    const same = clamp((kinship - UNLIKE) / (SAME - UNLIKE), 0, 1)
    return 1 / (1 + exp(6.6 + doubt - evidence - 1.9 * same * fullness + 2.5 * (1 - same)))
  })
}

/** Doubt about landmarks: without lids that close or lips that part, eyes and mouth are guessed. */
function doubtOf({ hasLids, seam, scales }: FaceFrame): number {
  if (!seam) return 5
  if (!hasLids) return 3
  const height = (2 * scales[0]) / scales[1]
  return height < HEIGHTS[0] || height > HEIGHTS[1] ? 2.5 : 0
}
