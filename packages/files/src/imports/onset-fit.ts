import { interpolateValues, lerp, reference } from 'furrow/internal'

/**
 * Approximation of a flow map by onset. The source mixes a wrinkle by `min(1, f + m) m`, where *f* is the flow and *m* the weight times the
 * activation *a*. Furrow mixes it by `onsetInfluence(w c(a), o, s)`. The fit chooses the curve *c*, the strength *s*, and an onset *o* and a
 * weight *w* for each flow and weight of the source.
 */
export interface OnsetFit {
  /** Strength of the onset map, 0 if the layer needs none. */
  strength: number
  /** Returns the activation in Furrow for an activation in the source, 0..1. */
  activationOf(activation: number): number
  /** Returns the onset of a texel for its flow and for its largest weight in the source, all 0..1. */
  onsetOf(flow: number, most: number): number
  /**
   * Returns the weight of an area for a weight in the source.
   *
   * @param most largest weight of all areas at this texel, which decides on the onset.
   */
  weightOf(flow: number, weight: number, most: number): number
  /** Largest error in steps of 1/255, for the largest change at each flow. */
  steps: number
}

/** Number of flows that are fitted. Others are interpolated. */
export const FLOW_LEVELS = 17
const WEIGHTS = spread(0, 1, 9)
const ACTIVATIONS = spread(0, 1, 33)
const ONSETS = spread(0, 0.98, 50)
const INFLUENCES = spread(0, 1, 201)
/** Weights of the source for which the curve is fitted. All others get their own onset and weight afterwards. */
const FITTED_WEIGHTS = [0.5, 1]
const COARSE_WEIGHTS = spread(0.1, 1, 19)
const FINE_WEIGHTS = spread(0, 1, 201)
const STRENGTHS = [0.2, 0.35, 0.5, 1]
/** The fit alternates between onsets and curve so many times. */
const ROUNDS = 8
/** An error below this many steps of 1/255 is not visible, so that no onset map is needed. */
const INVISIBLE = 0.5

/** Returns by how much the source mixes a wrinkle. */
export function flowInfluence(flow: number, amount: number): number {
  return Math.min(1, flow + amount) * amount
}

/**
 * Fits onset to a flow map.
 *
 * @param changes largest change that the wrinkles make at each of the `FLOW_LEVELS` flows, in steps of 1/255; 0 where no texel has this flow.
 */
export function fitOnset(changes: ArrayLike<number>): OnsetFit {
  const flows = spread(0, 1, FLOW_LEVELS)
  const levels = flows.flatMap((flow, level) =>
    changes[level] > 0 ? [{ flow, change: changes[level] }] : [],
  )
  if (levels.length === 0) levels.push({ flow: 1, change: 1 })
  const used = levels.flatMap((level) => FITTED_WEIGHTS.map((weight) => ({ ...level, weight })))
  let best = fitCurve(used, 0)
  if (best.steps > INVISIBLE) {
    for (const strength of STRENGTHS) {
      const fit = fitCurve(used, strength)
      if (fit.steps < best.steps) best = fit
    }
  }
  const { strength, curve, steps } = best
  const onsets = strength === 0 ? [0] : ONSETS
  const refitted = new Map<string, number>()
  const table = flows.map((flow) =>
    WEIGHTS.map((weight) => fitTexel(flow, weight, curve, strength, onsets, FINE_WEIGHTS)),
  )
  const lookup = (flow: number, weight: number) => {
    const [row, column] = [flow * (FLOW_LEVELS - 1), weight * (WEIGHTS.length - 1)]
    const [top, left] = [Math.floor(row), Math.floor(column)]
    const [bottom, right] = [Math.ceil(row), Math.ceil(column)]
    const value = (key: 'onset' | 'weight') => {
      const above = lerp(table[top][left][key], table[top][right][key], column - left)
      return lerp(above, lerp(table[bottom][left][key], table[bottom][right][key], column - left), row - top)
    }
    return { onset: value('onset'), weight: value('weight') }
  }
  return {
    strength,
    steps,
    activationOf: (activation) => interpolateValues(curve, activation),
    onsetOf: (flow, weight) => lookup(flow, weight).onset,
    weightOf: (flow, weight, most) => {
      if (weight === most || strength === 0) return lookup(flow, weight).weight
      // The onset fits another weight.
      const onset = Math.round(lookup(flow, most).onset * 50) / 50
      const [flowLevel, weightLevel] = [Math.round(flow * 16) / 16, Math.round(weight * 32) / 32]
      const key = `${flowLevel} ${weightLevel} ${onset}`
      const known =
        refitted.get(key) ?? fitTexel(flowLevel, weightLevel, curve, strength, [onset], FINE_WEIGHTS).weight
      refitted.set(key, known)
      return known
    },
  }
}

interface CurveFit {
  strength: number
  /** Influence per entry of `ACTIVATIONS`. */
  curve: number[]
  steps: number
}

/** A flow and a weight of the source, with the largest change that wrinkles make there in steps of 1/255. */
interface Used {
  flow: number
  weight: number
  change: number
}

function fitCurve(used: readonly Used[], strength: number): CurveFit {
  const onsets = strength === 0 ? [0] : ONSETS
  let curve = ACTIVATIONS.slice()
  let steps = Number.POSITIVE_INFINITY
  for (let round = 0; round < ROUNDS; round++) {
    const texels = used.map(({ flow, weight }) =>
      fitTexel(flow, weight, curve, strength, onsets, COARSE_WEIGHTS),
    )
    const next = ACTIVATIONS.map((activation) => {
      const error = (influence: number) => {
        let most = 0
        for (const [i, { flow, weight, change }] of used.entries()) {
          const shown = reference.onsetInfluence(texels[i].weight * influence, texels[i].onset, strength)
          most = Math.max(most, change * Math.abs(shown - flowInfluence(flow, weight * activation)))
        }
        return most
      }
      return leastOf(INFLUENCES, error).at
    })
    next[0] = 0
    next[next.length - 1] = 1
    const errors = used.map(({ flow, weight, change }, i) => {
      return change * worst(flow, weight, texels[i].weight, texels[i].onset, next, strength)
    })
    const error = Math.max(...errors)
    if (error >= steps) break
    steps = error
    curve = next
  }
  return { strength, curve, steps }
}

function fitTexel(
  flow: number,
  weight: number,
  curve: readonly number[],
  strength: number,
  onsets: readonly number[],
  weights: readonly number[],
) {
  if (weight === 0) return { onset: 0, weight: 0 }
  const candidates = weight === 1 ? [1] : weights
  let best = { onset: 0, weight, error: Number.POSITIVE_INFINITY }
  for (const onset of onsets) {
    const found = leastOf(candidates, (own) => worst(flow, weight, own, onset, curve, strength))
    if (found.value < best.error) best = { onset, weight: found.at, error: found.value }
  }
  return best
}

/** Returns the largest difference of influences over all activations. */
function worst(
  flow: number,
  weight: number,
  own: number,
  onset: number,
  curve: readonly number[],
  strength: number,
): number {
  let most = 0
  for (const [i, activation] of ACTIVATIONS.entries()) {
    const shown = reference.onsetInfluence(own * curve[i], onset, strength)
    most = Math.max(most, Math.abs(shown - flowInfluence(flow, weight * activation)))
  }
  return most
}

function leastOf(
  candidates: readonly number[],
  errorOf: (candidate: number) => number,
): { at: number; value: number } {
  let best = { at: candidates[0], value: Number.POSITIVE_INFINITY }
  for (const at of candidates) {
    const value = errorOf(at)
    if (value < best.value) best = { at, value }
  }
  return best
}

function spread(from: number, to: number, count: number): number[] {
  return Array.from({ length: count }, (_, i) => lerp(from, to, i / (count - 1)))
}
