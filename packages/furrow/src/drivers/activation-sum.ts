import { sentence } from '../core/error.ts'
import type { AreaActivation } from './activation.ts'
import { type CurvePoints, outputOf } from './curve.ts'

/** A link, its input resolved to values among the inputs or the areas' activations. */
export interface BoundLink {
  /** Of the input, for people. */
  name: string
  /** The input is the mean of these values; 0 if there are none. */
  indices: Uint16Array
  /** Whether the values are activations. */
  isArea: boolean
  weight: number
  /** Of its curve, if it has one. */
  points: CurvePoints | undefined
}

/** An area activation, its area and inputs resolved to indices. */
export interface BoundActivation {
  /** Index of the area. */
  area: number
  links: readonly BoundLink[]
  rule: AreaActivation['rule']
  /** Of its curve. */
  points: CurvePoints
}

/** Evaluates area activations in order. `addTo` allocates nothing, unless a registered rule does. */
export class ActivationSum {
  readonly #activations: readonly BoundActivation[]
  /** By driver: whether it adds up single inputs, as most do. */
  readonly #areSums: readonly boolean[]
  /** By driver and link: index of its input; -1 if that is an area or not just one value, or has a curve. */
  readonly #sources: readonly Int32Array[]
  /** The same: its weight. To read these of the links takes twice as long. */
  readonly #weights: readonly Float64Array[]
  /** The same: its value, before the rule. */
  readonly #linkValues: readonly Float64Array[]
  readonly #warned = new Set<string>()
  /** Result of `#read` and `#combine`; in an array, since a number that a function returns may be boxed. */
  readonly #value = new Float64Array(1)

  constructor(activations: readonly BoundActivation[]) {
    this.#activations = activations
    this.#sources = activations.map(({ links }) => Int32Array.from(links, sourceOf))
    this.#weights = activations.map(({ links }) => Float64Array.from(links, ({ weight }) => weight))
    this.#linkValues = activations.map(({ links }) => new Float64Array(links.length))
    this.#areSums = activations.map(({ rule }, i) => rule === 'sum' && !this.#sources[i].includes(-1))
  }

  /**
   * Adds to each area what its drivers give, up to 1. A driver reads areas as the drivers before it left them.
   *
   * @param areas activations by area; changed.
   * @param inputs values of all inputs.
   */
  addTo(areas: Float32Array, inputs: Float64Array): void {
    for (let i = 0; i < this.#activations.length; i++) {
      const { area, points } = this.#activations[i]
      if (!this.#areSums[i] || !this.#sum(i, inputs)) this.#combine(i, areas, inputs)
      areas[area] = Math.min(1, areas[area] + outputOf(points, this.#value[0]))
    }
  }

  /** The values of a driver's links, by its index, before the rule combines them and after. Allocates. */
  evaluate(index: number, areas: Float32Array, inputs: Float64Array): { links: number[]; combined: number } {
    this.#combine(index, areas, inputs)
    return { links: [...this.#linkValues[index]], combined: this.#value[0] }
  }

  /** As `#combine`, of single inputs. Returns false where one is NaN. */
  #sum(index: number, inputs: Float64Array): boolean {
    const sources = this.#sources[index]
    const weights = this.#weights[index]
    let sum = 0
    for (let i = 0; i < sources.length; i++) sum += inputs[sources[i]] * weights[i]
    this.#value[0] = sum
    return !Number.isNaN(sum)
  }

  #combine(index: number, areas: Float32Array, inputs: Float64Array): void {
    const { links, rule } = this.#activations[index]
    const sources = this.#sources[index]
    const weights = this.#weights[index]
    const values = this.#linkValues[index]
    let combined = rule === 'product' ? 1 : 0
    for (let i = 0; i < values.length; i++) {
      let value = sources[i] < 0 ? Number.NaN : inputs[sources[i]]
      if (Number.isNaN(value)) {
        this.#read(links[i], areas, inputs)
        value = this.#value[0]
      }
      value *= weights[i]
      values[i] = value
      if (rule === 'sum') combined += value
      else if (rule === 'product') combined *= value
      else if (i === 0) combined = value
      else combined = rule === 'min' ? Math.min(combined, value) : Math.max(combined, value)
    }
    this.#value[0] = typeof rule === 'function' ? rule(values) : combined
  }

  /** Reads the input of a link, and passes it through the link's curve. */
  #read(link: BoundLink, areas: Float32Array, inputs: Float64Array): void {
    const { name, points } = link
    const value = this.#value
    readInput(link, areas, inputs, value)
    if (Number.isNaN(value[0])) {
      this.#warn(name)
      value[0] = 0
    }
    if (points) value[0] = outputOf(points, value[0])
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

function sourceOf({ isArea, indices, points }: BoundLink): number {
  return isArea || points || indices.length !== 1 ? -1 : indices[0]
}
