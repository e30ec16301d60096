import { FurrowError, sentence } from './error.ts'
import { MAX_AREAS, MAX_LAYERS } from './limits.ts'
import type { Combine } from './types.ts'
import { listNames } from './wrinkle-set.ts'

/** An area as the activations see it: its place is its index in the list. */
export interface Slot {
  name: string
  layer: number
  combine: Combine
}

/**
 * The narrow waist: one number in 0..1 per area, bound by name, laid out for the GPU.
 *
 * `table` holds `MAX_AREAS` columns and two rows of four floats. Column i is area i; row 0 serves areas that
 * add up, row 1 those that combine by `max`; the activation stands in the channel of the area's layer, all
 * else is 0. So one loop sums every layer at once, and neither the number of areas nor the layer of an area is
 * part of a shader program.
 */
export class Activations {
  readonly table = new Float32Array(MAX_AREAS * 2 * MAX_LAYERS)
  /** Grows by one with every change; compare it to know whether to upload. */
  version = 0

  #slots: Slot[] = []
  #indices = new Map<string, number>()
  #values = new Float32Array(MAX_AREAS)
  #warned = false
  readonly #who: string

  constructor(slots: readonly Slot[], who = 'Activations') {
    this.#who = who
    this.rebind(slots)
  }

  /** Names in the order of the areas' array. */
  get slots(): readonly Slot[] {
    return this.#slots
  }

  /** Takes another list of areas; those whose names stay keep their activations. */
  rebind(slots: readonly Slot[]): void {
    const kept = slots.map(({ name }) => this.#values[this.#indices.get(name) ?? MAX_AREAS] ?? 0)
    this.#slots = slots.map((slot) => ({ ...slot }))
    this.#indices = new Map(slots.map(({ name }, index) => [name, index]))
    this.#values.fill(0)
    this.table.fill(0)
    for (const [index, value] of kept.entries()) this.#write(index, value)
    this.version++
  }

  /** @throws FurrowError when no area has that name. */
  get(name: string): number {
    return this.#values[this.#indexOf(name)]
  }

  /**
   * @param value 0..1; anything outside is clamped and NaN is taken as 0, with one warning per object.
   * @throws FurrowError when no area has that name.
   */
  set(name: string, value: number): void {
    const index = this.#indexOf(name)
    const allowed = value >= 0 && value <= 1 ? value : this.#clamp(name, value)
    if (this.#values[index] === Math.fround(allowed)) return
    this.#write(index, allowed)
    this.version++
  }

  /** Whether an area of that name exists. */
  has(name: string): boolean {
    return this.#indices.has(name)
  }

  #write(index: number, value: number): void {
    const { layer, combine } = this.#slots[index]
    const row = combine === 'max' ? 1 : 0
    this.#values[index] = value
    this.table[(row * MAX_AREAS + index) * MAX_LAYERS + layer] = value
  }

  #indexOf(name: string): number {
    const index = this.#indices.get(name)
    if (index !== undefined) return index
    throw new FurrowError({
      who: this.#who,
      what: 'unknown area',
      value: name,
      limit: listNames(this.#slots),
      remedy: 'use the name of an area of this set, or add the area first',
    })
  }

  #clamp(name: string, value: number): number {
    const allowed = value > 1 ? 1 : 0
    if (!this.#warned) {
      this.#warned = true
      console.warn(
        sentence({
          who: this.#who,
          what: `activation of "${name}" out of range`,
          value,
          limit: '0 to 1',
          remedy: `taken as ${allowed}; this is said once`,
        }),
      )
    }
    return allowed
  }
}
