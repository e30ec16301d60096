import { FurrowError } from './error.ts'

/** A point of the texture: u to the right, v downwards, both 0..1. */
export type Uv = [u: number, v: number]

/** Reads one JSON document; every complaint names the field by its path. */
export class JsonReader {
  readonly #who: string

  constructor(who: string) {
    this.#who = who
  }

  /** The value as an object; its keys are all among `known`, if that is given. Throws otherwise. */
  object(value: unknown, path: string, known?: readonly string[]): Record<string, unknown> {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) {
      const fields = known ? ` with ${known.join(', ')}` : ''
      this.fail(`${path} must be an object`, value, undefined, `write { ... }${fields}`)
    }
    for (const key of Object.keys(value)) {
      if (known && !known.includes(key)) {
        this.fail(`${path} has an unknown field`, key, known.join(', '), 'correct the name or remove it')
      }
    }
    return value as Record<string, unknown>
  }

  /** The value as an array of `low`..`high` items. Throws otherwise. */
  array(value: unknown, path: string, low: number, high: number): unknown[] {
    const range = `${low} to ${high} items`
    if (!Array.isArray(value)) this.fail(`${path} must be an array`, value, range, 'write [ ... ]')
    if (value.length < low || value.length > high) {
      this.fail(`${path} has the wrong number of items`, value.length, range, 'add or remove items')
    }
    return value
  }

  /** The value as a finite number in `low`..`high`. Throws otherwise. */
  number(value: unknown, path: string, low: number, high: number, unit: string): number {
    const range = `${low}..${high}${unit === '' ? '' : ` ${unit}`}`
    if (typeof value !== 'number' || !Number.isFinite(value)) {
      this.fail(`${path} must be a number`, value, range, 'write a plain number')
    }
    if (value < low || value > high) {
      this.fail(`${path} is out of range`, value, range, 'choose a value inside the range')
    }
    return value
  }

  /** The value as a whole number in `low`..`high`. Throws otherwise. */
  integer(value: unknown, path: string, low: number, high: number): number {
    const number = this.number(value, path, low, high, '')
    if (!Number.isInteger(number)) {
      this.fail(`${path} must be a whole number`, number, `${low}..${high}`, 'write it without a fraction')
    }
    return number
  }

  /** One number for both, or an array of two. Throws otherwise. */
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

  /** The value as text of 1 to `longest` characters. Throws otherwise. */
  text(value: unknown, path: string, longest = 64): string {
    if (typeof value !== 'string' || value === '' || value.length > longest) {
      this.fail(`${path} must be text`, value, `1 to ${longest} characters`, 'write it in quotes')
    }
    return value
  }

  /** The value as one of `allowed`. Throws otherwise. */
  choice<T extends string>(value: unknown, path: string, allowed: readonly T[]): T {
    if (!allowed.includes(value as T)) {
      this.fail(`${path} is unknown`, value, allowed.join(' or '), 'use one of them')
    }
    return value as T
  }

  /** An array of `low` to 4096 points [u, v], both 0..1. Throws otherwise. */
  points(value: unknown, path: string, low: number): Uv[] {
    return this.array(value, path, low, 4096).map((point, i) => {
      const [u, v] = this.array(point, `${path}[${i}]`, 2, 2)
      return [
        this.number(u, `${path}[${i}][0]`, 0, 1, 'of the texture'),
        this.number(v, `${path}[${i}][1]`, 0, 1, 'of the texture'),
      ]
    })
  }

  fail(what: string, value: unknown, limit: string | undefined, remedy: string): never {
    throw new FurrowError({ who: this.#who, what, value: shown(value), limit, remedy })
  }
}

/** Only what is absent has a default: glTF knows no null. */
export function or(value: unknown, usual: unknown): unknown {
  return value === undefined ? usual : value
}

/** Objects of strangers may lack a working `toString`, or be nested too deep; so they are turned into text here. */
function shown(value: unknown): unknown {
  if (value === undefined) return { toString: () => 'nothing' }
  if (typeof value !== 'object' || value === null) return value
  const text = jsonOf(value) ?? 'an object'
  return { toString: () => text }
}

function jsonOf(value: object): string | undefined {
  try {
    return JSON.stringify(value)
  } catch {
    return undefined
  }
}
