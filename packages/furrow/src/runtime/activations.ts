import { FurrowError, sentence } from '../core/error.ts'
import { MAX_AREAS } from '../core/limits.ts'
import { listNames } from '../core/wrinkle-set.ts'

/** The narrow waist: one number in 0..1 per area, bound by name. */
export class Activations {
  /** Grows by one with every change; compare it to know whether anything is to be done. */
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

  /** In the order of the areas; change them by `set`. */
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
   * Takes many over at once, by their places in the order of the areas; nothing is allocated.
   *
   * @param values 0..1.
   */
  take(places: ArrayLike<number>, values: Float32Array): void {
    for (let i = 0; i < places.length; i++) {
      if (this.#values[places[i]] === values[i]) continue
      this.#values[places[i]] = values[i]
      this.version++
    }
  }

  /**
   * Takes many over by name; those that do not exist are passed over. Nothing is allocated, as a number that is handed to `set` may be.
   *
   * @param values 0..1, in the order of the names.
   * @param except names that are passed over too.
   */
  takeNamed(names: readonly string[], values: Float32Array, except?: ReadonlySet<string>): void {
    for (let i = 0; i < names.length; i++) {
      const index = this.#indices.get(names[i])
      if (index === undefined || this.#values[index] === values[i] || except?.has(names[i])) continue
      this.#values[index] = values[i]
      this.version++
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
          remedy: `taken as ${allowed}; this is said once`,
        }),
      )
    }
    return allowed
  }
}
