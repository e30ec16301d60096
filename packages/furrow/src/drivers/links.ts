import { sentence } from '../core/error.ts'
import { applyCurve } from './curve.ts'
import type { Curve, Link, Rule } from './types.ts'

/** A driver that joins several inputs. */
export interface Linked {
  /** Place of its area in the list that results are added to. */
  area: number
  links: readonly Link[]
  rule: Rule
  curve: Curve
}

/** What a driver gives, and each of its links before rule and curve. */
export interface Joined {
  activation: number
  links: number[]
}

interface BoundLink {
  name: string
  indices: Uint16Array
  weight: number
  curve?: Curve
}

interface Bound {
  area: number
  links: readonly BoundLink[]
  rule: Rule
  curve: Curve
}

/** Drivers whose links are bound to places in one array of inputs. Nothing is allocated by `addTo`. */
export class BoundLinks {
  /** Names that no input has, and the place of the area they are for; they count as 0. */
  readonly unknown: readonly { name: string; area: number }[]
  readonly #bound: readonly Bound[]
  readonly #who: string
  readonly #warned = new Set<string>()
  /** What was read last; in an array, since a number that a function returns may be allocated. */
  readonly #value = new Float64Array(1)

  /** @param find places of an input by name: none, one, or those of its parts, of which the mean counts. */
  constructor(drivers: readonly Linked[], find: (name: string) => readonly number[], who: string) {
    const unknown: { name: string; area: number }[] = []
    this.#bound = drivers.map(({ area, links, rule, curve }) => ({
      area,
      rule,
      curve,
      links: links.map(({ name, weight, curve }) => {
        const indices = Uint16Array.from(find(name))
        if (indices.length === 0) unknown.push({ name, area })
        return { name, indices, weight, ...(curve && { curve }) }
      }),
    }))
    this.unknown = unknown
    this.#who = who
  }

  /**
   * Adds what the drivers make of the inputs to their areas.
   *
   * @param offset where the first input stands.
   */
  addTo(activations: Float32Array, inputs: ArrayLike<number>, offset: number): void {
    for (let i = 0; i < this.#bound.length; i++) this.#add(this.#bound[i], activations, inputs, offset)
  }

  /** What one driver makes of the inputs, by its place in the list. For looking: it allocates. */
  explain(driver: number, inputs: ArrayLike<number>): Joined {
    const bound = this.#bound[driver]
    const links = bound.links.map((link) => {
      this.#read(link, inputs, 0)
      return this.#value[0]
    })
    this.#join(bound, inputs, 0)
    return { activation: this.#value[0], links }
  }

  /** One driver after the other, each adding to its area; its inputs are read when it is its turn. */
  #add(bound: Bound, activations: Float32Array, inputs: ArrayLike<number>, offset: number): void {
    this.#join(bound, inputs, offset)
    activations[bound.area] = Math.min(1, activations[bound.area] + this.#value[0])
  }

  /** What a driver gives. */
  #join({ links, rule, curve }: Bound, inputs: ArrayLike<number>, offset: number): void {
    const value = this.#value
    let joined = rule === 'product' ? 1 : 0
    for (let i = 0; i < links.length; i++) {
      this.#read(links[i], inputs, offset)
      if (rule === 'sum') joined += value[0]
      else if (rule === 'product') joined *= value[0]
      else if (i === 0) joined = value[0]
      else joined = rule === 'max' ? Math.max(joined, value[0]) : Math.min(joined, value[0])
    }
    value[0] = joined
    applyCurve(curve, value)
  }

  /** What a link gives. */
  #read({ name, indices, weight, curve }: BoundLink, inputs: ArrayLike<number>, offset: number): void {
    const value = this.#value
    value[0] = 0
    for (let k = 0; k < indices.length; k++) value[0] += inputs[offset + indices[k]] / indices.length
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
        who: this.#who,
        what: `the weight of "${name}" is no number`,
        value: Number.NaN,
        remedy: 'it counts as 0; this is said once',
      }),
    )
  }
}
