import { FurrowError } from '../core/error.ts'

/**
 * Numbers that the application sets by name, for drivers of type `age` and `input`: the person's age, stress, cold, loudness. Each
 * instance has its own.
 */
export class NamedInputs {
  readonly #values = new Map<string, Float64Array>()
  readonly #faces: number

  /** @param faces number of instances. */
  constructor(faces: number) {
    this.#faces = faces
  }

  /** Names that a driver reads or that were set. */
  get names(): string[] {
    return [...this.#values.keys()]
  }

  /**
   * Sets an input. Names that no driver reads are allowed: drivers may come later.
   *
   * @param value in the unit that the drivers' curves expect, e.g. years.
   * @param instance of an instanced mesh; all by default.
   * @throws FurrowError when the value is NaN or infinite, or there is no such instance.
   */
  set(name: string, value: number, instance?: number): void {
    if (!Number.isFinite(value)) {
      throw new FurrowError({
        who: 'Wrinkles.inputs',
        what: `value of "${name}" is NaN or infinite`,
        value,
        limit: 'a finite number',
        remedy: 'set one, e.g. inputs.set("age", 40)',
      })
    }
    const values = this.declare(name, 0)
    if (instance === undefined) values.fill(value)
    else {
      this.#check(instance)
      values[instance] = value
    }
  }

  /** The value of an input: as it was set, else what its drivers start from (`age`: 20), else 0. */
  get(name: string, instance = 0): number {
    this.#check(instance)
    return this.#values.get(name)?.[instance] ?? 0
  }

  /**
   * Makes sure that an input exists.
   *
   * @param initial its value until it is set.
   * @returns its value for each instance; changes as it is set.
   */
  declare(name: string, initial: number): Float64Array {
    const known = this.#values.get(name)
    if (known) return known
    const values = new Float64Array(this.#faces).fill(initial)
    this.#values.set(name, values)
    return values
  }

  #check(instance: number): void {
    if (Number.isInteger(instance) && instance >= 0 && instance < this.#faces) return
    throw new FurrowError({
      who: 'Wrinkles.inputs',
      what: 'no such instance',
      value: instance,
      limit: `0 to ${this.#faces - 1}`,
      remedy: 'use the index of an instance of the mesh',
    })
  }
}
