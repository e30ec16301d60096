import { wrongArgument } from '../core/argument.ts'
import { FurrowError, formatProblem } from '../core/error.ts'
import { didYouMean } from '../core/nearest-name.ts'

/** Custom inputs: numbers set by the application for `age` and `input` drivers, such as stress or cold. Each instance has its own values. */
export class NamedInputs {
  readonly #values = new Map<string, Float64Array>()
  /** Names that drivers read. */
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

  /** Names read by a driver or set by the application. */
  get names(): string[] {
    return [...this.#values.keys()]
  }

  /**
   * Sets an input. Warns once if drivers exist but none reads the name.
   *
   * @param value value in the unit of the drivers' curves, e.g. years.
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
   * Returns the value of an input: the last set value, otherwise the drivers' initial value (`age`: default 20), otherwise 0.
   *
   * @param instance index of an instance; default 0.
   * @throws FurrowError if the instance does not exist.
   */
  get(name: string, instance = 0): number {
    checkInstance(instance, this.#faces, 'Wrinkles.inputs')
    return this.#values.get(name)?.[instance] ?? 0
  }

  /**
   * Creates an input that a driver reads, if missing.
   *
   * @param initial value until the application sets the input.
   * @returns current value of each instance; always the same array.
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

/** @throws FurrowError unless `instance` is an index below `count`. */
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
