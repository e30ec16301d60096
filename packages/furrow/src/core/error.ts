/**
 * The kind of an error, for programs. Messages may change between versions, codes do not.
 *
 * | code | meaning |
 * | --- | --- |
 * | `invalid` | a value or file is not what it must be; the default |
 * | `out-of-range` | a number, size or count is beyond its limit |
 * | `unknown-name` | nothing has that name: a mesh, blendshape, area, or one of a fixed list |
 * | `unreadable` | a file or image is missing, cut off, or in an unknown format |
 * | `unwritable` | a file cannot be written |
 * | `unsupported` | the material, renderer, browser or memory at hand cannot do it |
 * | `usage` | the command line is not understood |
 */
export type ErrorCode =
  | 'invalid'
  | 'out-of-range'
  | 'unknown-name'
  | 'unreadable'
  | 'unwritable'
  | 'unsupported'
  | 'usage'

/** The parts of every Furrow error, in the order in which they are printed. */
export interface ErrorParts {
  /** `invalid` by default. */
  code?: ErrorCode
  /** Who reports it: the class, function or command that the caller used. */
  who: string
  /** What is wrong. */
  problem: string
  /** The value that was given. */
  value?: unknown
  /** What would have been accepted. */
  limit?: string | undefined
  /** What the caller can do about it. */
  remedy: string
}

/** The one error class of the package: `Module: what, the value, the limit; the remedy`. */
export class FurrowError extends Error implements ErrorParts {
  override readonly name = 'FurrowError'
  declare readonly code: ErrorCode
  declare readonly who: string
  declare readonly problem: string
  readonly value: unknown
  readonly limit: string | undefined
  declare readonly remedy: string

  constructor(parts: ErrorParts, options?: ErrorOptions) {
    super(sentence(parts), options)
    Object.assign(this, parts, { code: parts.code ?? 'invalid' })
  }

  /** The same error as `who` would report it: callers of a function know nothing of those that it calls. */
  reportedBy(who: string): FurrowError {
    return new FurrowError({ ...this, who }, { cause: this })
  }
}

/** One problem as one line, for errors and warnings alike. */
export function sentence({ who, problem, value, limit, remedy }: ErrorParts): string {
  const given = value === undefined ? '' : `, got ${printable(value)}`
  const allowed = limit === undefined ? '' : `, allowed: ${limit}`
  return `${who}: ${problem}${given}${allowed}; ${remedy}`
}

/** At most 120 characters. */
function printable(value: unknown): string {
  const isPlain = (typeof value !== 'object' || value === null) && typeof value !== 'string'
  const text = isPlain ? String(value) : (toJson(value) ?? 'an object')
  return text.length > 120 ? `${text.slice(0, 117)}...` : text
}

/** Undefined where there is none: parsed JSON may be nested too deeply, and other objects may be cyclic. */
function toJson(value: unknown): string | undefined {
  try {
    return JSON.stringify(value)
  } catch {
    return undefined
  }
}
