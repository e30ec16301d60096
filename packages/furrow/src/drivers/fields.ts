import { type JsonReader, orDefault } from '../core/json.ts'
import { LARGEST, LONGEST_NAME, MAX_CURVE_POINTS, MAX_LINKS } from '../core/limits.ts'
import type { Rule } from './activation.ts'
import type { Curve, CurvePoint } from './curve.ts'
import type { Link } from './link.ts'

type Json = Record<string, unknown>

/**
 * Reads the JSON fields of one driver, or of an object in it. Every method throws a FurrowError that names the field if it is
 * missing, has the wrong type or is out of range.
 */
export class Fields {
  /** Names of all areas. */
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

  /** `area`: the name of an area that exists. */
  area(): string {
    return this.choice('area', this.areas)
  }

  /** `rule`, `sum` by default. */
  rule(): Rule {
    return this.choice('rule', ['sum', 'max', 'min', 'product'], 'sum')
  }

  /** `weight`, -1000..1000, 1 by default. */
  weight(): number {
    return this.number('weight', -LARGEST, LARGEST, 1)
  }

  /** A name of 1 to 256 characters. */
  name(field: string): string {
    return this.#reader.text(this.#json[field], `${this.#at}.${field}`, LONGEST_NAME)
  }

  /** A number from `low` to `high`; `fallback` if it is absent. */
  number(field: string, low: number, high: number, fallback: number): number {
    return this.#reader.number(orDefault(this.#json[field], fallback), `${this.#at}.${field}`, low, high, '')
  }

  /** One of the allowed values; `fallback` if it is absent. */
  choice<T extends string>(field: string, allowed: readonly T[], fallback?: T): T {
    return this.#reader.choice(orDefault(this.#json[field], fallback), `${this.#at}.${field}`, allowed)
  }

  /** Two names. */
  names(field: string): [string, string] {
    const path = `${this.#at}.${field}`
    const [a, b] = this.#reader.array(this.#json[field], path, 2, 2)
    return [
      this.#reader.text(a, `${path}[0]`, LONGEST_NAME),
      this.#reader.text(b, `${path}[1]`, LONGEST_NAME),
    ]
  }

  /**
   * At least one link.
   *
   * @param known the allowed names; any by default.
   */
  links(field: string, known?: readonly string[]): Link[] {
    const read = (item: Fields) => ({
      name: known ? item.choice('name', known) : item.name('name'),
      weight: item.weight(),
      ...(item.has('curve') && { curve: item.#curve(-LARGEST, LARGEST) }),
    })
    return this.list(field, read, 1)
  }

  /** Items of an array; none if the field is absent and `least`, the number required, is 0. */
  list<T>(field: string, read: (item: Fields) => T, least = 0): T[] {
    const path = `${this.#at}.${field}`
    const value = least === 0 ? orDefault(this.#json[field], []) : this.#json[field]
    return this.#reader.array(value, path, least, MAX_LINKS).map((item, i) => {
      const at = `${path}[${i}]`
      return read(new Fields(this.#reader, this.#reader.object(item, at), at, this.areas))
    })
  }

  /** `curve`, whose outputs are activations, 0..1; `fallback` if it is absent. */
  curve(fallback?: readonly CurvePoint[]): Curve {
    return this.#curve(0, 1, fallback)
  }

  /** Whether the field is present. */
  has(field: string): boolean {
    return this.#json[field] !== undefined
  }

  /** `axis`, of any length but 0; nothing if it is absent. */
  axis(): { axis?: [number, number, number] } {
    if (!this.has('axis')) return {}
    const [x, y, z] = this.#vector('axis', 3)
    if (Math.hypot(x, y, z) > 0) return { axis: [x, y, z] }
    this.#reader.fail(`${this.#at}.axis has no direction`, '0, 0, 0', undefined, 'write e.g. 1, 0, 0')
  }

  /** `direction` in texture coordinates, of any length but 0; nothing if it is absent. */
  direction(): { direction?: [number, number] } {
    if (!this.has('direction')) return {}
    const [u, v] = this.#vector('direction', 2)
    if (Math.hypot(u, v) > 0) return { direction: [u, v] }
    this.#reader.fail(`${this.#at}.direction has no direction`, '0, 0', undefined, 'write e.g. 1, 0')
  }

  /** `origin` and `insertion` of a muscle, which differ. */
  muscleAxis(): Record<'origin' | 'insertion', [number, number, number]> {
    const point = (field: string): [number, number, number] => {
      const [x, y, z] = this.#vector(field, 3)
      return [x, y, z]
    }
    const [origin, insertion] = [point('origin'), point('insertion')]
    if (origin.some((value, i) => value !== insertion[i])) return { origin, insertion }
    const at = `${this.#at}.insertion`
    this.#reader.fail(`${at} equals the origin`, insertion.join(', '), undefined, 'give the muscle a length')
  }

  /** `inner` and `outer` of a muscle: where its pull is strongest and where it ends, as fractions of its length. */
  zone(): { inner: number; outer: number } {
    const [inner, outer] = [this.number('inner', 0, 10, 0.8), this.number('outer', 0.001, 10, 1.2)]
    if (outer > inner) return { inner, outer }
    this.#reader.fail(
      `${this.#at}.outer is too small`,
      outer,
      `more than ${inner}`,
      'make it larger than inner',
    )
  }

  #vector(field: string, size: number): number[] {
    const path = `${this.#at}.${field}`
    return this.#reader
      .array(this.#json[field], path, size, size)
      .map((value, i) => this.#reader.number(value, `${path}[${i}]`, -LARGEST, LARGEST, ''))
  }

  #curve(low: number, high: number, fallback?: readonly CurvePoint[]): Curve {
    const reader = this.#reader
    const at = `${this.#at}.curve`
    const points = reader.array(orDefault(this.#json.curve, fallback), at, 2, MAX_CURVE_POINTS)
    const curve = points.map((item, i): CurvePoint => {
      const [input, output] = reader.array(item, `${at}[${i}]`, 2, 2)
      return [
        reader.number(input, `${at}[${i}][0]`, -LARGEST, LARGEST, ''),
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
