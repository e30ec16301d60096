import { sentence } from '../core/error.ts'
import type { AreaActivation } from './activation.ts'
import { applyCurve } from './curve.ts'

/** Where a link's input is: in the inputs, or among the areas' activations. */
export interface BoundLink {
  name: string
  /** It is the mean of these; 0 where there are none. */
  indices: Uint16Array
  isArea: boolean
  weight: number
  curve?: AreaActivation['curve']
}

/** An area activation with its area and inputs found. */
export interface BoundActivation {
  /** Index of the area. */
  area: number
  links: readonly BoundLink[]
  rule: AreaActivation['rule']
  curve: AreaActivation['curve']
}

/** What a driver gives, and each of its links before rule and curve. */
export interface Contribution {
  activation: number
  links: number[]
}

/** Evaluates area activations one after the other. Nothing is allocated by `addTo`, unless a registered rule does. */
export class ActivationSum {
  readonly #activations: readonly BoundActivation[]
  /** Scratch for registered rules: one value per link. */
  readonly #linkValues: readonly Float64Array[]
  readonly #warned = new Set<string>()
  /** What was read last; in an array, since a number that a function returns may be boxed. */
  readonly #value = new Float64Array(1)

  constructor(activations: readonly BoundActivation[]) {
    this.#activations = activations
    this.#linkValues = activations.map(({ links }) => new Float64Array(links.length))
  }

  /** Adds to each area what its drivers give, to at most 1; an area is read as it is when it is a driver's turn. */
  addTo(areas: Float32Array, inputs: Float64Array): void {
    for (let i = 0; i < this.#activations.length; i++) {
      const { area } = this.#activations[i]
      this.#combine(i, areas, inputs)
      areas[area] = Math.min(1, areas[area] + this.#value[0])
    }
  }

  /** What one driver gives, by its index. Allocates. */
  explain(index: number, areas: Float32Array, inputs: Float64Array): Contribution {
    const links = this.#activations[index].links.map((link) => {
      this.#read(link, areas, inputs)
      return this.#value[0]
    })
    this.#combine(index, areas, inputs)
    return { activation: this.#value[0], links }
  }

  #combine(index: number, areas: Float32Array, inputs: Float64Array): void {
    const { links, rule, curve } = this.#activations[index]
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
    applyCurve(curve, value)
  }

  #read(
    { name, indices, isArea, weight, curve }: BoundLink,
    areas: Float32Array,
    inputs: Float64Array,
  ): void {
    const value = this.#value
    const from = isArea ? areas : inputs
    value[0] = 0
    for (let k = 0; k < indices.length; k++) value[0] += from[indices[k]] / indices.length
    if (Number.isNaN(value[0])) {
      this.#warn(name)
      value[0] = 0
    }
    if (curve) applyCurve(curve, value)
    value[0] *= weight
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
