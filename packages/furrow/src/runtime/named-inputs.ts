import { wrongArgument } from '../core/argument.ts'
import { FurrowError, sentence } from '../core/error.ts'
import { didYouMean } from '../core/nearest-name.ts'

/**
 * Numbers that the application sets by name, for drivers of type `age` and `input`: the person's age, stress, cold, loudness. Each
 * instance of a mesh has its own values.
 */
export class NamedInputs {
  readonly #values = new Map<string, Float64Array>()
  /** Names that drivers read. */
  readonly #read = new Set<string>()
  readonly #warned = new Set<string>()
  readonly #faces: number
  readonly #checkInUse: (method: string) => void

  /**
   * @param faces number of instances, 1 for any other mesh.
   * @param checkInUse throws when the wrinkles were disposed of.
   */
  constructor(faces: number, checkInUse: (method: string) => void) {
    this.#faces = faces
    this.#checkInUse = checkInUse
  }

  /** Names that a driver reads or that have been set. */
  get names(): string[] {
    return [...this.#values.keys()]
  }

  /**
   * Sets an input. The name may be one that no driver reads yet; warns once if the drivers read others.
   *
   * @param value in the unit that the drivers' curves expect, e.g. years.
   * @param instance index of an instance; all instances by default.
   * @throws FurrowError when the value is NaN or infinite, the instance does not exist, or the wrinkles were disposed of.
   */
  set(name: string, value: number, instance?: number): void {
    this.#checkInUse('inputs')
    if (typeof name !== 'string') throw wrongArgument('Wrinkles.inputs', 'name of an input', name, 'text')
    if (instance !== undefined) checkInstance(instance, this.#faces, 'Wrinkles.inputs')
    if (!Number.isFinite(value)) {
      throw new FurrowError({
        who: 'Wrinkles.inputs',
        problem: `value of "${name}" is NaN or infinite`,
        value,
        limit: 'a finite number',
        remedy: 'set one, e.g. inputs.set("age", 40)',
      })
    }
    if (this.#read.size > 0 && !this.#read.has(name)) this.#warn(name)
    const values = this.#valuesOf(name, 0)
    if (instance === undefined) values.fill(value)
    else values[instance] = value
  }

  /**
   * The value of an input: as set, or its drivers' initial value (`age`: 20 unless the file says otherwise), or 0.
   *
   * @param instance index of an instance, 0 by default.
   * @throws FurrowError when the instance does not exist.
   */
  get(name: string, instance = 0): number {
    checkInstance(instance, this.#faces, 'Wrinkles.inputs')
    return this.#values.get(name)?.[instance] ?? 0
  }

  /**
   * Creates an input that a driver reads, if it does not exist.
   *
   * @param initial its value until it is set.
   * @returns its current value for each instance; always the same array.
   * @internal
   */
  declare(name: string, initial: number): Float64Array {
    this.#read.add(name)
    return this.#valuesOf(name, initial)
  }

  #valuesOf(name: string, initial: number): Float64Array {
    const known = this.#values.get(name)
    if (known) return known
    const values = new Float64Array(this.#faces).fill(initial)
    this.#values.set(name, values)
    return values
  }

  #warn(name: string): void {
    if (this.#warned.has(name)) return
    this.#warned.add(name)
    const names = [...this.#read]
    console.warn(
      sentence({
        who: 'Wrinkles.inputs',
        problem: 'no driver of this face reads the input',
        value: name,
        limit: names.join(', '),
        remedy: didYouMean(name, names, 'it has no effect'),
      }),
    )
  }
}

/** @throws FurrowError when there is no instance of that index among `count`. */
export function checkInstance(instance: number, count: number, who: string): void {
  if (Number.isInteger(instance) && instance >= 0 && instance < count) return
  throw new FurrowError({
    who,
    problem: 'no such instance',
    value: instance,
    limit: `0 to ${count - 1}`,
    remedy: 'use the index of an instance of the mesh',
  })
}
