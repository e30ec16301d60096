import { JsonReader, or } from '../core/json.ts'
import { LARGEST, LONGEST_NAME } from '../core/limits.ts'
import {
  type Curve,
  type CurvePoint,
  type DriverOf,
  type DriverType,
  type Link,
  type Rule,
  STRAIGHT,
  type WrinkleDriver,
} from './types.ts'

const MAX_DRIVERS = 4096
const MAX_LINKS = 1024
const MAX_CURVE_POINTS = 64
/** Seconds. */
const SLOWEST = 60

type Vector = [number, number, number]
type Json = Record<string, unknown>
type Read<T extends DriverType> = (fields: Fields) => Omit<DriverOf<T>, 'type'>

/** How the fields of each type are read; what is not here is kept as it is. */
const TYPES: { [T in DriverType]: Read<T> } = {
  morph: (fields) => ({
    area: fields.area(),
    targets: fields.links('targets'),
    rule: fields.rule(),
    curve: fields.curve(STRAIGHT),
  }),
  area: (fields) => ({
    area: fields.area(),
    areas: fields.links('areas', fields.areas),
    rule: fields.rule(),
    curve: fields.curve(STRAIGHT),
  }),
  conflict: (fields) => ({ targets: fields.names('targets') }),
  bone: (fields) => ({
    area: fields.area(),
    joints: fields.names('joints'),
    measure: fields.choice('measure', ['angle', 'distance']),
    ...fields.axis(),
    curve: fields.curve(),
  }),
  tension: (fields) => ({
    area: fields.area(),
    measure: fields.choice('measure', ['compression', 'stretch'], 'compression'),
    curve: fields.curve(),
  }),
  muscle: (fields) => ({
    name: fields.name('name'),
    ...(fields.has('area') && { area: fields.area() }),
    kind: fields.choice('kind', ['linear', 'sheet', 'sphincter'], 'linear'),
    ...fields.stretch(),
    angle: fields.number('angle', 0.001, 1.57, 0.5),
    width: fields.number('width', 0.0001, LARGEST, 0.01),
    ...fields.zone(),
    strength: fields.number('strength', -1, 1, 0.3),
  }),
  age: (fields) => ({ area: fields.area(), curve: fields.curve() }),
  time: (fields) => ({
    area: fields.area(),
    attack: fields.number('attack', 0, SLOWEST, 0),
    release: fields.number('release', 0, SLOWEST, 0),
  }),
  expression: (fields) => ({
    name: fields.name('name'),
    targets: fields.list('targets', (item) => ({ name: item.name('name'), weight: item.weight() })),
    activations: fields.list('activations', (item) => ({
      area: item.area(),
      activation: item.number('activation', 0, 1, 1),
    })),
  }),
}

/**
 * Reads drivers from JSON, as `drivers` of the format are written, and fills their defaults in.
 *
 * @param json a list, whatever is in it.
 * @param areas names that drivers may use.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseDrivers(json: unknown, areas: readonly string[], who = 'parseDrivers'): WrinkleDriver[] {
  const named = areas.map((name) => ({ name }))
  return readDrivers(new JsonReader(who), json, named)
}

/**
 * Reads a list of drivers; none when it is absent. Types that this version does not know are kept as they are.
 *
 * @param areas that drivers may name.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function readDrivers(
  reader: JsonReader,
  value: unknown,
  areas: readonly { name: string }[],
): WrinkleDriver[] {
  const names = areas.map(({ name }) => name)
  return reader.array(or(value, []), 'drivers', 0, MAX_DRIVERS).map((item, i) => {
    const at = `drivers[${i}]`
    const json = reader.object(item, at)
    const type = reader.text(json.type, `${at}.type`)
    if (!Object.hasOwn(TYPES, type)) return { ...json, type }
    const read = TYPES[type as DriverType] as Read<DriverType>
    return { type, ...read(new Fields(reader, json, at, names)) }
  })
}

/** The fields of one driver, or of something in one. */
class Fields {
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

  area(): string {
    return this.choice('area', this.areas)
  }

  rule(): Rule {
    return this.choice('rule', ['sum', 'max', 'min', 'product'], 'sum')
  }

  weight(): number {
    return this.number('weight', -LARGEST, LARGEST, 1)
  }

  name(field: string): string {
    return this.#reader.text(this.#json[field], `${this.#at}.${field}`, LONGEST_NAME)
  }

  number(field: string, low: number, high: number, usual: number): number {
    return this.#reader.number(or(this.#json[field], usual), `${this.#at}.${field}`, low, high, '')
  }

  choice<T extends string>(field: string, allowed: readonly T[], usual?: T): T {
    return this.#reader.choice(or(this.#json[field], usual), `${this.#at}.${field}`, allowed)
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

  /** @param known the only names there are, if that is so. */
  links(field: string, known?: readonly string[]): Link[] {
    const read = (item: Fields) => ({
      name: known ? item.choice('name', known) : item.name('name'),
      weight: item.weight(),
      ...(item.has('curve') && { curve: item.#curve(-LARGEST, LARGEST) }),
    })
    return this.list(field, read, 1)
  }

  /** None where the field is absent, unless there must be some. */
  list<T>(field: string, read: (item: Fields) => T, least = 0): T[] {
    const path = `${this.#at}.${field}`
    const value = least === 0 ? or(this.#json[field], []) : this.#json[field]
    return this.#reader.array(value, path, least, MAX_LINKS).map((item, i) => {
      const at = `${path}[${i}]`
      return read(new Fields(this.#reader, this.#reader.object(item, at), at, this.areas))
    })
  }

  /** One whose outputs are activations. */
  curve(usual?: readonly CurvePoint[]): Curve {
    return this.#curve(0, 1, usual)
  }

  has(field: string): boolean {
    return this.#json[field] !== undefined
  }

  axis(): { axis?: Vector } {
    if (!this.has('axis')) return {}
    const axis = this.#vector('axis')
    if (Math.hypot(...axis) > 0) return { axis }
    this.#reader.fail(`${this.#at}.axis has no direction`, '0, 0, 0', undefined, 'write e.g. 1, 0, 0')
  }

  /** The two ends of a muscle. */
  stretch(): { origin: Vector; insertion: Vector } {
    const [origin, insertion] = [this.#vector('origin'), this.#vector('insertion')]
    if (origin.some((value, i) => value !== insertion[i])) return { origin, insertion }
    const at = `${this.#at}.insertion`
    this.#reader.fail(`${at} is the origin`, insertion.join(', '), undefined, 'give the muscle a length')
  }

  /** Where a muscle's pull is strongest and where it ends. */
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

  #vector(field: string): Vector {
    const path = `${this.#at}.${field}`
    return this.#reader
      .array(this.#json[field], path, 3, 3)
      .map((value, i) => this.#reader.number(value, `${path}[${i}]`, -LARGEST, LARGEST, '')) as Vector
  }

  #curve(low: number, high: number, usual?: readonly CurvePoint[]): Curve {
    const reader = this.#reader
    const at = `${this.#at}.curve`
    const points = reader.array(or(this.#json.curve, usual), at, 2, MAX_CURVE_POINTS)
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
      reader.fail(`${at}[${i}][0] does not grow`, curve[i][0], limit, 'sort the points by their input')
    }
    return curve
  }
}
