import { type ActivationSum, type BoundActivation, readInput } from './activation-sum.ts'
import { outputOf } from './curve.ts'

/** Contribution of one driver to its area. */
export interface Contribution {
  /** 0..1. */
  activation: number
  /** Value of each input, before the link's curve and weight. */
  inputs: number[]
  /** Value of each link, before the driver's rule and curve. */
  links: number[]
  /** Links combined by the rule: the input of the curve. */
  combined: number
}

/** Computes the contribution of a driver by its index in `sum`. Allocates. */
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
    // NaN counts as 0.
    return value[0] || 0
  })
  const { links: linkValues, combined } = sum.evaluate(index, areas, inputs)
  return { activation: outputOf(points, combined), inputs: inputValues, links: linkValues, combined }
}
