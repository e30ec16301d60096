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

/** Evaluates area activations in order. `addTo` allocates nothing, unless a registered rule does. */
export class ActivationSum {
  readonly #activations: readonly BoundActivation[]
  /** Scratch: one value per link. */
  readonly #linkValues: readonly Float64Array[]
  readonly #warned = new Set<string>()
  /** Result of `#read` and `#combine`; in an array, since a number that a function returns may be boxed. */
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

  #combine(index: number, areas: Float32Array, inputs: Float64Array): void {
    const { links, rule } = this.#activations[index]
    const values = this.#linkValues[index]
    for (let i = 0; i < links.length; i++) {
      this.#read(links[i], areas, inputs)
      values[i] = this.#value[0]
    }
    combine(rule, values, this.#value)
  }

  #read(link: BoundLink, areas: Float32Array, inputs: Float64Array): void {
    const { name, weight, curve } = link
    const value = this.#value
    readInput(link, areas, inputs, value)
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

/** Reads the input of a link, before its curve and weight, into `value`. */
export function readInput(
  { indices, isArea }: BoundLink,
  areas: Float32Array,
  inputs: Float64Array,
  value: Float64Array,
): void {
  const from = isArea ? areas : inputs
  value[0] = 0
  for (let k = 0; k < indices.length; k++) value[0] += from[indices[k]] / indices.length
}

/** Combines the values of a driver's links by its rule, into `value`. */
export function combine(rule: AreaActivation['rule'], values: Float64Array, value: Float64Array): void {
  if (typeof rule === 'function') {
    value[0] = rule(values)
    return
  }
  value[0] = rule === 'product' ? 1 : 0
  for (let i = 0; i < values.length; i++) {
    if (rule === 'sum') value[0] += values[i]
    else if (rule === 'product') value[0] *= values[i]
    else if (i === 0) value[0] = values[0]
    else value[0] = rule === 'min' ? Math.min(value[0], values[i]) : Math.max(value[0], values[i])
  }
}
