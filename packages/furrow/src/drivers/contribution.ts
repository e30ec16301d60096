import { type BoundActivation, combine, readInput } from './activation-sum.ts'
import { curveAt } from './curve.ts'

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

/** What a driver adds to its area, as `ActivationSum` computes it. Allocates. */
export function contributionOf(
  { links, rule, curve }: BoundActivation,
  areas: Float32Array,
  inputs: Float64Array,
): Contribution {
  const value = new Float64Array(1)
  const inputValues = links.map((link) => {
    readInput(link, areas, inputs, value)
    // Those that are not numbers count as 0.
    return value[0] || 0
  })
  const linkValues = links.map(
    ({ weight, curve }, i) => weight * (curve ? curveAt(curve, inputValues[i]) : inputValues[i]),
  )
  combine(rule, Float64Array.from(linkValues), value)
  const [combined] = value
  return { activation: curveAt(curve, combined), inputs: inputValues, links: linkValues, combined }
}
