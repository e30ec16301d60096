import { FurrowError, sentence } from '../core/error.ts'
import { MAX_AREAS } from '../core/limits.ts'
import { listNames } from '../core/wrinkle-set.ts'

/** The activation vector: one number in 0..1 per area, bound by name. */
export class Activations {
  /** Grows by one with every change. */
  version = 0

  #areas: readonly { name: string }[] = []
  #indices = new Map<string, number>()
  #warned = false
  readonly #values = new Float32Array(MAX_AREAS)
  readonly #who: string

  constructor(areas: readonly { name: string }[], who = 'Activations') {
    this.#who = who
    this.rebind(areas)
  }

  /** In the order of the areas, 0 beyond them; read only. */
  get values(): Float32Array {
    return this.#values
  }

  /** Names of the areas, in their order. */
  get names(): string[] {
    return this.#areas.map(({ name }) => name)
  }

  /** Takes another list of areas; those whose names stay keep their activations. */
  rebind(areas: readonly { name: string }[]): void {
    const kept = areas.map(({ name }) => this.#values[this.#indices.get(name) ?? MAX_AREAS] ?? 0)
    this.#areas = areas.map(({ name }) => ({ name }))
    this.#indices = new Map(areas.map(({ name }, index) => [name, index]))
    this.#values.fill(0)
    this.#values.set(kept)
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
    this.#values[index] = allowed
    this.version++
  }

  /**
   * Sets one by its index, from a list; nothing is allocated, as a number that is passed to `set` may be boxed.
   *
   * @param values 0..1.
   * @param at index of the value in the list.
   */
  setAt(index: number, values: Float32Array, at: number): void {
    if (this.#values[index] === values[at]) return
    this.#values[index] = values[at]
    this.version++
  }

  /**
   * Sets many by name; names that no area has are ignored. Nothing is allocated.
   *
   * @param values 0..1, in the order of the names.
   * @param except names that are ignored too.
   */
  setNamed(names: readonly string[], values: Float32Array, except?: ReadonlySet<string>): void {
    for (let i = 0; i < names.length; i++) {
      const index = this.#indices.get(names[i])
      if (index === undefined || except?.has(names[i])) continue
      this.setAt(index, values, i)
    }
  }

  /** Whether an area of that name exists. */
  has(name: string): boolean {
    return this.#indices.has(name)
  }

  #indexOf(name: string): number {
    const index = this.#indices.get(name)
    if (index !== undefined) return index
    throw new FurrowError({
      code: 'unknown-name',
      who: this.#who,
      what: 'unknown area',
      value: name,
      limit: listNames(this.#areas),
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
          remedy: `clamped to ${allowed}; this warning is not repeated`,
        }),
      )
    }
    return allowed
  }
}
