import { type ActivationSum, type BoundActivation, readInput } from './activation-sum.ts'
import { outputOf } from './curve.ts'

/** Intermediate results of one driver. Tools use them to explain the activation of the driver's area. */
export interface Contribution {
  /** Activation that the driver adds to its area, 0..1. */
  activation: number
  /** Value of each input. */
  inputs: number[]
  /** Result of each link: `weight * curve(input)`. */
  links: number[]
  /** Combination of the links by the driver's rule. The driver's curve converts this number to the activation. */
  combined: number
}

/**
 * Computes the intermediate results of a driver. Allocates.
 *
 * @param index index of the driver in `sum`.
 */
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
