import { wrongArgument } from '../core/argument.ts'
import { unknownArea } from '../core/check-areas.ts'
import { formatProblem } from '../core/error.ts'
import { MAX_AREAS } from '../core/limits.ts'

/** Buffer for one activation. V8 may allocate memory for a number that is passed to a function, so activations are passed in arrays. */
const scratch = new Float32Array(1)

/**
 * Activations of one face. Each area (group of wrinkles) has an activation from 0 to 1, where 1 means that its wrinkles are fully visible.
 * Areas are addressed by name.
 */
export class Activations {
  /** Incremented on every change. */
  version = 0

  /** Activations in the order of the areas, padded with zeros to 256. Read-only. The array is never replaced. */
  readonly values = new Float32Array(MAX_AREAS)

  #indices = new Map<string, number>()
  #warned = false
  readonly #who: string

  /**
   * @param areas at most 256, with unique names. Activations start at 0.
   * @param who name of the object in errors.
   */
  constructor(areas: readonly { name: string }[], who = 'Activations') {
    this.#who = who
    this.rebind(areas)
  }

  get names(): string[] {
    return [...this.#indices.keys()]
  }

  /** Replaces the list of areas. Areas in both lists keep their activations. New areas start at 0. */
  rebind(areas: readonly { name: string }[]): void {
    const kept = areas.map(({ name }) => (this.has(name) ? this.get(name) : 0))
    this.#indices = new Map(areas.map(({ name }, index) => [name, index]))
    this.values.fill(0)
    this.values.set(kept)
    this.version++
  }

  /**
   * Returns the activation of an area, 0..1.
   *
   * @throws FurrowError if the name is unknown.
   */
  get(name: string): number {
    return this.values[this.#indexOf(name)]
  }

  /**
   * Sets the activation of an area.
   *
   * @param value 0..1. Other values are clamped, and NaN becomes 0. The first such value logs a warning.
   * @throws FurrowError if the name is unknown or `value` is not of type number.
   */
  set(name: string, value: number): void {
    const index = this.#indexOf(name)
    if (typeof value !== 'number') throw wrongArgument(this.#who, `activation of "${name}"`, value, '0 to 1')
    if (!(value >= 0 && value <= 1)) this.#warn(name, value)
    scratch[0] = value
    this.setAt(index, scratch, 0)
  }

  /**
   * Sets the activation of an area by index. Unlike `set`, this method allocates nothing, because the value is passed in an array.
   *
   * @param index index of the area.
   * @param values contains the activation. Values outside 0..1 are clamped, and NaN becomes 0.
   * @param source index of the activation in `values`.
   */
  setAt(index: number, values: Float32Array, source: number): void {
    let value = values[source]
    if (!(value >= 0 && value <= 1)) value = value > 1 ? 1 : 0
    if (this.values[index] === value) return
    this.values[index] = value
    this.version++
  }

  /**
   * Sets several activations by name. Unknown names are ignored. Allocates nothing.
   *
   * @param values activations, 0..1, in the order of the names.
   * @param except names to skip.
   */
  setNamed(names: readonly string[], values: Float32Array, except?: ReadonlySet<string>): void {
    for (let i = 0; i < names.length; i++) {
      const index = this.#indices.get(names[i])
      if (index === undefined || except?.has(names[i])) continue
      this.setAt(index, values, i)
    }
  }

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
      formatProblem({
        who: this.#who,
        problem: `activation of "${name}" out of range`,
        value,
        limit: '0 to 1',
        remedy: `clamped to ${value > 1 ? 1 : 0}; this warning is not repeated`,
      }),
    )
  }
}
