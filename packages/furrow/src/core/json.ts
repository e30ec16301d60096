import { type ErrorCode, FurrowError } from './error.ts'
import { isName, NAME_RULE } from './name.ts'
import { didYouMean } from './nearest-name.ts'

/** Texture coordinates: u to the right, v downwards, both 0..1. */
export type Uv = [u: number, v: number]

/**
 * Reads and checks a JSON document field by field. All methods throw a FurrowError for invalid values. The error names the path of the
 * field, e.g. `areas[2].name`.
 */
export class JsonReader {
  readonly #who: string

  constructor(who: string) {
    this.#who = who
  }

  /** Reads an object. If `known` is given, the object must not have other keys. */
  object(value: unknown, path: string, known?: readonly string[]): Record<string, unknown> {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) {
      const fields = known ? ` with ${known.join(', ')}` : ''
      this.fail(`${path} must be an object`, value, undefined, `write { ... }${fields}`)
    }
    for (const key of Object.keys(value)) {
      if (known && !known.includes(key)) {
        this.fail(
          `${path} has an unknown field`,
          key,
          known.join(', '),
          didYouMean(key, known, 'correct the name or remove it'),
          'unknown-name',
        )
      }
    }
    return value as Record<string, unknown>
  }

  /** Reads an array of `low` to `high` items. */
  array(value: unknown, path: string, low: number, high: number): unknown[] {
    const range = `${low} to ${high} items`
    if (!Array.isArray(value)) this.fail(`${path} must be an array`, value, range, 'write [ ... ]')
    if (value.length < low || value.length > high) {
      this.fail(
        `${path} has the wrong number of items`,
        value.length,
        range,
        'add or remove items',
        'out-of-range',
      )
    }
    return value
  }

  /** Reads a finite number from `low` to `high`. */
  number(value: unknown, path: string, low: number, high: number, unit: string): number {
    const range = `${low}..${high}${unit === '' ? '' : ` ${unit}`}`
    if (typeof value !== 'number' || !Number.isFinite(value)) {
      this.fail(`${path} must be a number`, value, range, 'write a plain number')
    }
    if (value < low || value > high) {
      this.fail(`${path} is out of range`, value, range, 'choose a value inside the range', 'out-of-range')
    }
    return value
  }

  integer(value: unknown, path: string, low: number, high: number): number {
    const number = this.number(value, path, low, high, '')
    if (!Number.isInteger(number)) {
      this.fail(`${path} must be a whole number`, number, `${low}..${high}`, 'write it without a fraction')
    }
    return number
  }

  /** Reads two numbers from `low` to `high`. A single number is returned twice. */
  pair(value: unknown, path: string, low: number, high: number): [number, number] {
    if (!Array.isArray(value)) {
      const both = this.number(value, path, low, high, '')
      return [both, both]
    }
    this.array(value, path, 2, 2)
    return [
      this.number(value[0], `${path}[0]`, low, high, ''),
      this.number(value[1], `${path}[1]`, low, high, ''),
    ]
  }

  /** Reads text of 1 to `longest` characters. */
  text(value: unknown, path: string, longest = 64): string {
    if (typeof value !== 'string' || value === '' || value.length > longest) {
      this.fail(`${path} must be text`, value, `1 to ${longest} characters`, 'write it in quotes')
    }
    return value
  }

  /** Reads a name that `isName` accepts. */
  name(value: unknown, path: string): string {
    if (!isName(value)) this.fail(`${path} must be text`, value, NAME_RULE, 'choose another name')
    return value
  }

  choice<T extends string>(value: unknown, path: string, allowed: readonly T[]): T {
    if (!allowed.includes(value as T)) {
      this.fail(`${path} is unknown`, value, allowed.join(' or '), 'use one of them', 'unknown-name')
    }
    return value as T
  }

  points(value: unknown, path: string, low: number): Uv[] {
    return this.array(value, path, low, 4096).map((point, i) => this.point(point, `${path}[${i}]`))
  }

  /** Reads a point `[u, v]`. Both coordinates are 0..1. */
  point(value: unknown, path: string): Uv {
    const [u, v] = this.array(value, path, 2, 2)
    return [
      this.number(u, `${path}[0]`, 0, 1, 'of the texture'),
      this.number(v, `${path}[1]`, 0, 1, 'of the texture'),
    ]
  }

  /** Throws a FurrowError. If `value` is undefined, the message says "got nothing". */
  fail(message: string, value: unknown, limit: string | undefined, remedy: string, code?: ErrorCode): never {
    const problem = value === undefined ? `${message}, got nothing` : message
    throw new FurrowError({ code, who: this.#who, problem, value, limit, remedy })
  }
}

/** Calls `read`. If it throws a FurrowError, passes the error to `onError` and returns undefined. */
export function tryRead<T>(read: () => T, onError: (error: FurrowError) => void): T | undefined {
  try {
    return read()
  } catch (error) {
    if (!(error instanceof FurrowError)) throw error
    onError(error)
    return undefined
  }
}

/** Returns `fallback` if the value is undefined. Null is returned unchanged, so that later checks reject it: glTF does not allow null. */
export function orDefault(value: unknown, fallback: unknown): unknown {
  return value === undefined ? fallback : value
}
