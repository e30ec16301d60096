import { sentence } from '../core/error.ts'
import type { AreaActivation } from './activation.ts'
import { applyCurve } from './curve.ts'

/** A link, its input resolved to values among the inputs or the areas' activations. */
export interface BoundLink {
  /** Of the input, for people. */
  name: string
  /** The input is the mean of these values; 0 if there are none. */
  indices: Uint16Array
  /** Whether the values are activations. */
  isArea: boolean
  weight: number
  curve?: AreaActivation['curve']
}

/** An area activation, its area and inputs resolved to indices. */
export interface BoundActivation {
  /** Index of the area. */
  area: number
  links: readonly BoundLink[]
  rule: AreaActivation['rule']
  curve: AreaActivation['curve']
}

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

/** Evaluates area activations in order. `addTo` allocates nothing, unless a registered rule does. */
export class ActivationSum {
  readonly #activations: readonly BoundActivation[]
  /** Scratch for registered rules: one value per link. */
  readonly #linkValues: readonly Float64Array[]
  readonly #warned = new Set<string>()
  /** Result of `#readInput`, `#read` and `#combine`; in an array, since a number that a function returns may be boxed. */
  readonly #value = new Float64Array(1)

  constructor(activations: readonly BoundActivation[]) {
    this.#activations = activations
    this.#linkValues = activations.map(({ links }) => new Float64Array(links.length))
  }

  /**
   * Adds to each area what its drivers give, up to 1. A driver reads areas as the drivers before it left them.
   *
   * @param areas activations by area; changed.
   * @param inputs values of all inputs.
   */
  addTo(areas: Float32Array, inputs: Float64Array): void {
    for (let i = 0; i < this.#activations.length; i++) {
      const { area, curve } = this.#activations[i]
      this.#combine(i, areas, inputs)
      applyCurve(curve, this.#value)
      areas[area] = Math.min(1, areas[area] + this.#value[0])
    }
  }

  /** The contribution of one driver, by its index. Allocates. */
  explain(index: number, areas: Float32Array, inputs: Float64Array): Contribution {
    const { links, curve } = this.#activations[index]
    const value = this.#value
    const inputValues = links.map((link) => {
      this.#readInput(link, areas, inputs)
      return value[0]
    })
    const linkValues = links.map((link) => {
      this.#read(link, areas, inputs)
      return value[0]
    })
    this.#combine(index, areas, inputs)
    const combined = value[0]
    applyCurve(curve, value)
    return { activation: value[0], inputs: inputValues, links: linkValues, combined }
  }

  #combine(index: number, areas: Float32Array, inputs: Float64Array): void {
    const { links, rule } = this.#activations[index]
    const value = this.#value
    const values = this.#linkValues[index]
    let combined = rule === 'product' ? 1 : 0
    for (let i = 0; i < links.length; i++) {
      this.#read(links[i], areas, inputs)
      values[i] = value[0]
      if (rule === 'sum') combined += value[0]
      else if (rule === 'product') combined *= value[0]
      else if (i === 0) combined = value[0]
      else combined = rule === 'min' ? Math.min(combined, value[0]) : Math.max(combined, value[0])
    }
    value[0] = typeof rule === 'function' ? rule(values) : combined
  }

  #read(link: BoundLink, areas: Float32Array, inputs: Float64Array): void {
    const { weight, curve } = link
    const value = this.#value
    this.#readInput(link, areas, inputs)
    if (curve) applyCurve(curve, value)
    value[0] *= weight
  }

  #readInput({ name, indices, isArea }: BoundLink, areas: Float32Array, inputs: Float64Array): void {
    const value = this.#value
    const from = isArea ? areas : inputs
    value[0] = 0
    for (let k = 0; k < indices.length; k++) value[0] += from[indices[k]] / indices.length
    if (Number.isNaN(value[0])) {
      this.#warn(name)
      value[0] = 0
    }
  }

  #warn(name: string): void {
    if (this.#warned.has(name)) return
    this.#warned.add(name)
    console.warn(
      sentence({
        who: 'Wrinkles',
        what: `the input "${name}" of a driver is NaN`,
        value: Number.NaN,
        remedy: 'it counts as 0; this warning is not repeated',
      }),
    )
  }
}
