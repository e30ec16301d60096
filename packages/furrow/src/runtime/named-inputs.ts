import { wrongArgument } from '../core/argument.ts'
import { FurrowError, formatProblem } from '../core/error.ts'
import { didYouMean } from '../core/nearest-name.ts'

/** Numbers, such as age or stress, that an application sets for `age` and `input` drivers. Each instance has separate values. */
export class NamedInputs {
  readonly #values = new Map<string, Float64Array>()
  /** Names of inputs that drivers read. */
  readonly #read = new Set<string>()
  readonly #warned = new Set<string>()
  readonly #faces: number
  readonly #checkInUse: (method: string) => void

  /**
   * @param faces number of instances; 1 for meshes without instances.
   * @param checkInUse throws if the wrinkles have been disposed.
   */
  constructor(faces: number, checkInUse: (method: string) => void) {
    this.#faces = faces
    this.#checkInUse = checkInUse
  }

  /** Names of all inputs that a driver reads or the application has set. */
  get names(): string[] {
    return [...this.#values.keys()]
  }

  /**
   * Sets an input. Logs a warning if drivers read other inputs but none reads this one.
   *
   * @param value number in the unit that the drivers expect, e.g. years.
   * @param instance index of an instance; default: all instances.
   * @throws FurrowError if the value is NaN or infinite, the instance does not exist, or the wrinkles have been disposed.
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
        remedy: 'set a number, e.g. inputs.set("age", 40)',
      })
    }
    if (this.#read.size > 0 && !this.#read.has(name)) this.#warn(name)
    const values = this.#valuesOf(name, 0)
    if (instance === undefined) values.fill(value)
    else values[instance] = value
  }

  /**
   * Returns the value of an input. If the application has not set the input, returns the initial value in the driver (20 for `age` by
   * default), or 0 if no driver reads the input.
   *
   * @param instance index of an instance; default 0.
   * @throws FurrowError if the instance does not exist.
   */
  get(name: string, instance = 0): number {
    checkInstance(instance, this.#faces, 'Wrinkles.inputs')
    return this.#values.get(name)?.[instance] ?? 0
  }

  /**
   * Registers an input that a driver reads.
   *
   * @param initial value until the application sets the input.
   * @returns current value of each instance. Later calls with this name return the same array.
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
      formatProblem({
        who: 'Wrinkles.inputs',
        problem: 'no driver of this face reads the input',
        value: name,
        limit: names.join(', '),
        remedy: didYouMean(name, names, 'the input has no effect'),
      }),
    )
  }
}

/** @throws FurrowError unless `instance` is an integer from 0 to `count - 1`. */
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
