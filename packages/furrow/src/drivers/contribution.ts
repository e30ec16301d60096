import { type ActivationSum, type BoundActivation, readInput } from './activation-sum.ts'
import { outputOf } from './curve.ts'

/** What one driver adds to its area. */
export interface Contribution {
  /** 0..1. */
  activation: number
  /** Value of each input, before the link's curve and weight. */
  inputs: number[]
  /** Value of each link, before rule and curve. */
  links: number[]
  /** The links combined by the rule: what the curve reads. */
  combined: number
}

/** What a driver adds to its area, by its index among those of `sum`. Allocates. */
export function contributionOf(
  sum: ActivationSum,
  index: number,
  { links, points }: BoundActivation,
  areas: Float32Array,
  inputs: Float64Array,
): Contribution {
  const value = new Float64Array(1)
  const inputValues = links.map((link) => {
    readInput(link, areas, inputs, value)
    // Those that are not numbers count as 0.
    return value[0] || 0
  })
  const { links: linkValues, combined } = sum.evaluate(index, areas, inputs)
  return { activation: outputOf(points, combined), inputs: inputValues, links: linkValues, combined }
}
