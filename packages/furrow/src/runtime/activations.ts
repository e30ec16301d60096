import { wrongArgument } from '../core/argument.ts'
import { unknownArea } from '../core/check-areas.ts'
import { sentence } from '../core/error.ts'
import { MAX_AREAS } from '../core/limits.ts'

/** Of one activation, since a number that is passed may be boxed. */
const given = new Float32Array(1)

/** The activation vector: one number, 0..1, per area, bound by name. */
export class Activations {
  /** Incremented by every change. */
  version = 0

  /** In the order of the areas, 0 beyond them; always the same array. Read only. */
  readonly values = new Float32Array(MAX_AREAS)

  /** By name, in their order. */
  #indices = new Map<string, number>()
  #warned = false
  readonly #who: string

  /**
   * @param areas at most 256, with distinct names. Their activations are 0.
   * @param who names the object in errors.
   */
  constructor(areas: readonly { name: string }[], who = 'Activations') {
    this.#who = who
    this.rebind(areas)
  }

  /** Names of the areas, in order. */
  get names(): string[] {
    return [...this.#indices.keys()]
  }

  /** Changes the list of areas. Those whose names stay keep their activations; others are 0. */
  rebind(areas: readonly { name: string }[]): void {
    const kept = areas.map(({ name }) => (this.has(name) ? this.get(name) : 0))
    this.#indices = new Map(areas.map(({ name }, index) => [name, index]))
    this.values.fill(0)
    this.values.set(kept)
    this.version++
  }

  /**
   * The activation of an area, 0..1.
   *
   * @throws FurrowError when no area has that name.
   */
  get(name: string): number {
    return this.values[this.#indexOf(name)]
  }

  /**
   * Sets the activation of an area.
   *
   * @param value 0..1; others are clamped and NaN counts as 0, with one warning per object.
   * @throws FurrowError when no area has that name.
   */
  set(name: string, value: number): void {
    const index = this.#indexOf(name)
    if (typeof value !== 'number') throw wrongArgument(this.#who, `activation of "${name}"`, value, '0 to 1')
    if (!(value >= 0 && value <= 1)) this.#warn(name, value)
    given[0] = value
    this.setAt(index, given, 0)
  }

  /**
   * Sets an activation by the index of its area. Allocates nothing, unlike `set`, whose argument may be boxed.
   *
   * @param values 0..1; others are clamped, and NaN counts as 0.
   * @param source index of the value among them.
   */
  setAt(index: number, values: Float32Array, source: number): void {
    let value = values[source]
    if (!(value >= 0 && value <= 1)) value = value > 1 ? 1 : 0
    if (this.values[index] === value) return
    this.values[index] = value
    this.version++
  }

  /**
   * Sets several activations by name; names that no area has are ignored. Allocates nothing.
   *
   * @param values 0..1, in the order of the names.
   * @param except names to ignore as well.
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
    throw unknownArea(name, this.names, this.#who)
  }

  #warn(name: string, value: number): void {
    if (this.#warned) return
    this.#warned = true
    console.warn(
      sentence({
        who: this.#who,
        problem: `activation of "${name}" out of range`,
        value,
        limit: '0 to 1',
        remedy: `clamped to ${value > 1 ? 1 : 0}; this warning is not repeated`,
      }),
    )
  }
}
