import { type JsonReader, orDefault } from '../core/json.ts'
import { MAX_CURVE_POINTS, MAX_LINKS, MAX_NAME_LENGTH, MAX_NUMBER } from '../core/limits.ts'
import type { Rule } from './activation.ts'
import type { Curve, CurvePoint } from './curve.ts'
import type { Link } from './link.ts'

type Json = Record<string, unknown>

/**
 * Reads and checks the JSON fields of a driver, or of an object in a driver. If a field is missing, has the wrong type or is out of range,
 * methods throw a FurrowError with the field's name.
 */
export class Fields {
  /** Names of all areas of the wrinkle set. */
  readonly areas: readonly string[]
  readonly #reader: JsonReader
  readonly #json: Json
  readonly #at: string

  constructor(reader: JsonReader, json: Json, at: string, areas: readonly string[]) {
    this.#reader = reader
    this.#json = json
    this.#at = at
    this.areas = areas
  }

  /** Reads the field `area`, which must be one of `areas`. */
  area(): string {
    return this.choice('area', this.areas)
  }

  /** Reads the field `rule`, default `sum`. */
  rule(): Rule {
    return this.choice('rule', ['sum', 'max', 'min', 'product'], 'sum')
  }

  /** Reads the field `weight`, -1000..1000, default 1. */
  weight(): number {
    return this.number('weight', -MAX_NUMBER, MAX_NUMBER, 1)
  }

  /** Reads a name of 1 to 256 characters. */
  name(field: string): string {
    return this.#reader.text(this.#json[field], `${this.#at}.${field}`, MAX_NAME_LENGTH)
  }

  /** Reads a number from `low` to `high`. Returns `fallback` if the field is missing. */
  number(field: string, low: number, high: number, fallback: number): number {
    return this.#reader.number(orDefault(this.#json[field], fallback), `${this.#at}.${field}`, low, high, '')
  }

  /** Reads one of the allowed values. Returns `fallback` if the field is missing. */
  choice<T extends string>(field: string, allowed: readonly T[], fallback?: T): T {
    return this.#reader.choice(orDefault(this.#json[field], fallback), `${this.#at}.${field}`, allowed)
  }

  /** Reads a list of two names. */
  names(field: string): [string, string] {
    const path = `${this.#at}.${field}`
    const [a, b] = this.#reader.array(this.#json[field], path, 2, 2)
    return [
      this.#reader.text(a, `${path}[0]`, MAX_NAME_LENGTH),
      this.#reader.text(b, `${path}[1]`, MAX_NAME_LENGTH),
    ]
  }

  /**
   * Reads an array of at least one link. A link is an input with a name, a weight and an optional curve.
   *
   * @param known allowed names. By default, any name is allowed.
   */
  links(field: string, known?: readonly string[]): Link[] {
    const read = (item: Fields) => ({
      name: known ? item.choice('name', known) : item.name('name'),
      weight: item.weight(),
      ...(item.has('curve') && { curve: item.#curve(-MAX_NUMBER, MAX_NUMBER) }),
    })
    return this.list(field, read, 1)
  }

  /** Reads an array of at least `least` items. Returns an empty array if the field is missing and `least` is 0. */
  list<T>(field: string, read: (item: Fields) => T, least = 0): T[] {
    const path = `${this.#at}.${field}`
    const value = least === 0 ? orDefault(this.#json[field], []) : this.#json[field]
    return this.#reader.array(value, path, least, MAX_LINKS).map((item, i) => {
      const at = `${path}[${i}]`
      return read(new Fields(this.#reader, this.#reader.object(item, at), at, this.areas))
    })
  }

  /** Reads the field `curve`, a curve with outputs 0..1. Returns `fallback` if the field is missing. */
  curve(fallback?: readonly CurvePoint[]): Curve {
    return this.#curve(0, 1, fallback)
  }

  /** Returns whether the field exists. */
  has(field: string): boolean {
    return this.#json[field] !== undefined
  }

  /** Reads the optional field `axis`, a vector of any length except 0. */
  axis(): { axis?: [number, number, number] } {
    if (!this.has('axis')) return {}
    const [x, y, z] = this.#vector('axis', 3)
    if (Math.hypot(x, y, z) > 0) return { axis: [x, y, z] }
    this.#reader.fail(`${this.#at}.axis has length zero`, '0, 0, 0', undefined, 'write e.g. [1, 0, 0]')
  }

  /** Reads the optional field `direction`, a vector in texture coordinates. Its length must not be 0. */
  direction(): { direction?: [number, number] } {
    if (!this.has('direction')) return {}
    const [u, v] = this.#vector('direction', 2)
    if (Math.hypot(u, v) > 0) return { direction: [u, v] }
    this.#reader.fail(`${this.#at}.direction has length zero`, '0, 0', undefined, 'write e.g. [1, 0]')
  }

  /** Reads the fields `origin` and `insertion` of a muscle, two points that must differ. */
  muscleAxis(): Record<'origin' | 'insertion', [number, number, number]> {
    const point = (field: string): [number, number, number] => {
      const [x, y, z] = this.#vector(field, 3)
      return [x, y, z]
    }
    const [origin, insertion] = [point('origin'), point('insertion')]
    if (origin.some((value, i) => value !== insertion[i])) return { origin, insertion }
    const at = `${this.#at}.insertion`
    this.#reader.fail(
      `${at} equals the origin`,
      insertion.join(', '),
      undefined,
      'move one of the two points',
    )
  }

  /** Reads the fields `inner` and `outer` of a muscle, see `MuscleDriver`. `outer` must be larger than `inner`. */
  zone(): { inner: number; outer: number } {
    const [inner, outer] = [this.number('inner', 0, 10, 0.8), this.number('outer', 0.001, 10, 1.2)]
    if (outer > inner) return { inner, outer }
    this.#reader.fail(
      `${this.#at}.outer is too small`,
      outer,
      `more than ${inner}`,
      'make outer larger than inner',
    )
  }

  #vector(field: string, size: number): number[] {
    const path = `${this.#at}.${field}`
    return this.#reader
      .array(this.#json[field], path, size, size)
      .map((value, i) => this.#reader.number(value, `${path}[${i}]`, -MAX_NUMBER, MAX_NUMBER, ''))
  }

  #curve(low: number, high: number, fallback?: readonly CurvePoint[]): Curve {
    const reader = this.#reader
    const at = `${this.#at}.curve`
    const points = reader.array(orDefault(this.#json.curve, fallback), at, 2, MAX_CURVE_POINTS)
    const curve = points.map((item, i): CurvePoint => {
      const [input, output] = reader.array(item, `${at}[${i}]`, 2, 2)
      return [
        reader.number(input, `${at}[${i}][0]`, -MAX_NUMBER, MAX_NUMBER, ''),
        reader.number(output, `${at}[${i}][1]`, low, high, ''),
      ]
    })
    for (let i = 1; i < curve.length; i++) {
      if (curve[i][0] > curve[i - 1][0]) continue
      const limit = `more than ${curve[i - 1][0]}`
      reader.fail(`${at}[${i}][0] does not increase`, curve[i][0], limit, 'sort the points by their input')
    }
    return curve
  }
}
