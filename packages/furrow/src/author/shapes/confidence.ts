import { clamp } from '../../math/scalar.ts'
import type { Match } from './match.ts'
import type { ShapeFields } from './shape-fields.ts'

/** Confidence below which a shape is unknown. */
export const UNSURE = 0.3
/** Confidence from which on a shape overrules its name. */
export const SURE = 0.7

/** Labels of a full set of ARKit's, and the score from which on a label counts as found. */
const FULL_SET = 51
const FOUND = 0.45

/**
 * The confidence of each match, 0..1: a logistic function of its score, its margin to other labels and the motion beyond the face. The share of
 * ARKit's set that is there counts too, since shapes of a full set decide each other's labels. The weights are fitted to heads of several families, to
 * parts of their sets, and to proportions, compositions and corrections of them.
 */
export function confidencesOf({ shapes }: ShapeFields, matches: readonly Match[]): number[] {
  const found = matches.filter(({ isFirst, score }) => isFirst && score > FOUND).length
  const fullness = clamp((found / FULL_SET - 0.5) / 0.4, 0, 1)
  return matches.map(({ shape, score, margin, isFirst }) => {
    const evidence =
      8 * score + 30 * Math.min(margin, 0.08) + 6 * Math.min(margin, 0.3) - 5.5 * shapes[shape].outside - 8.2
    return 1 / (1 + Math.exp(-(evidence + (isFirst ? 1.5 * fullness : -2.7))))
  })
}
