import { formatProblem } from '../core/error.ts'
import type { AreaActivation } from './activation.ts'
import { type CurvePoints, outputOf } from './curve.ts'

/** A link is an input of a driver with a weight and a curve. In a bound link, the input is resolved to indices of values. */
export interface BoundLink {
  /** Name of the input in messages. */
  name: string
  /** Indices of the values whose mean is the input. Without indices, the input is 0. */
  indices: Uint16Array
  /** Whether the indices refer to activations of areas. Otherwise, they refer to input values. */
  isArea: boolean
  weight: number
  /** Points of the link's curve, if it has one. */
  points: CurvePoints | undefined
}

/** A driver that activates an area. Its area and its inputs are resolved to indices. */
export interface BoundActivation {
  area: number
  links: readonly BoundLink[]
  rule: AreaActivation['rule']
  /** Points of the driver's curve. */
  points: CurvePoints
}

/** Evaluates all drivers that activate areas (groups of wrinkles), in order. `addTo` allocates nothing, unless a custom rule does. */
export class ActivationSum {
  readonly #activations: readonly BoundActivation[]
  readonly #areaIndices: Uint16Array
  readonly #curves: readonly CurvePoints[]
  /** For each driver, whether it sums links that read one input value each. Most drivers do, so this case has a faster path. */
  readonly #areSums: readonly boolean[]
  /** For each driver, the end of its links in `#sources` and `#weights`. Reading these flat arrays is twice as fast as reading objects. */
  readonly #ends: Uint32Array
  /** For each link, the index of its input value, or -1 if the link reads an area, reads several values or has a curve. */
  readonly #sources: Int32Array
  readonly #weights: Float64Array
  /** Results of the links, one array per driver. */
  readonly #linkValues: readonly Float64Array[]
  readonly #warned = new Set<string>()
  /** Result of `#read` and `#combine`, stored in an array because V8 may allocate memory for a returned number. */
  readonly #value = new Float64Array(1)

  constructor(activations: readonly BoundActivation[]) {
    const links = activations.flatMap((own) => own.links)
    this.#activations = activations
    this.#areaIndices = Uint16Array.from(activations, ({ area }) => area)
    this.#curves = activations.map(({ points }) => points)
    this.#areSums = activations.map(
      (own) => own.rule === 'sum' && own.links.every((link) => sourceOf(link) >= 0),
    )
    let end = 0
    this.#ends = Uint32Array.from(activations, (own) => (end += own.links.length))
    this.#sources = Int32Array.from(links, sourceOf)
    this.#weights = Float64Array.from(links, ({ weight }) => weight)
    this.#linkValues = activations.map((own) => new Float64Array(own.links.length))
  }

  /**
   * Adds the output of each driver to the activation of its area, up to 1. If a driver reads an area, it gets that area's activation so far.
   *
   * @param areas activations of all areas; modified.
   * @param inputs all input values.
   */
  addTo(areas: Float32Array, inputs: Float64Array): void {
    const activations = this.#activations
    const areSums = this.#areSums
    const sources = this.#sources
    const weights = this.#weights
    const ends = this.#ends
    const areaIndices = this.#areaIndices
    const curves = this.#curves
    let link = 0
    for (let i = 0; i < activations.length; i++) {
      const end = ends[i]
      let sum = Number.NaN
      if (areSums[i]) for (sum = 0; link < end; link++) sum += inputs[sources[link]] * weights[link]
      link = end
      if (Number.isNaN(sum)) {
        this.#combine(i, areas, inputs)
        sum = this.#value[0]
      }
      const area = areaIndices[i]
      areas[area] = Math.min(1, areas[area] + outputOf(curves[i], sum))
    }
  }

  /** Returns the results of a driver's links, and the number to which the driver's rule combines them. Allocates. */
  evaluate(index: number, areas: Float32Array, inputs: Float64Array): { links: number[]; combined: number } {
    this.#combine(index, areas, inputs)
    return { links: [...this.#linkValues[index]], combined: this.#value[0] }
  }

  #combine(index: number, areas: Float32Array, inputs: Float64Array): void {
    const { links, rule } = this.#activations[index]
    const values = this.#linkValues[index]
    const first = this.#ends[index] - values.length
    let combined = rule === 'product' ? 1 : 0
    for (let i = 0; i < values.length; i++) {
      const source = this.#sources[first + i]
      let value = source < 0 ? Number.NaN : inputs[source]
      if (Number.isNaN(value)) {
        this.#read(links[i], areas, inputs)
        value = this.#value[0]
      }
      value *= this.#weights[first + i]
      values[i] = value
      if (rule === 'sum') combined += value
      else if (rule === 'product') combined *= value
      else if (i === 0) combined = value
      else combined = rule === 'min' ? Math.min(combined, value) : Math.max(combined, value)
    }
    this.#value[0] = typeof rule === 'function' ? rule(values) : combined
  }

  /** Reads the input of a link and applies the link's curve. */
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
      formatProblem({
        who: 'Wrinkles',
        problem: `driver input "${name}" is not a number`,
        value: Number.NaN,
        remedy: 'the input counts as 0; this warning is not repeated',
      }),
    )
  }
}

/** Writes the input of a link to `value[0]`, without the link's curve and weight. */
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
