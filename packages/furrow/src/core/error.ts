/**
 * Machine-readable kind of an error. Messages may change between versions; codes do not.
 *
 * - `invalid`: invalid value or file; the default
 * - `out-of-range`: number, size or count outside its limits
 * - `unknown-name`: no mesh, blendshape, area or option has the name
 * - `unreadable`: file or image missing, truncated or in an unknown format
 * - `unwritable`: file cannot be written
 * - `unsupported`: the material, renderer or browser lacks a feature, or memory is insufficient
 * - `usage`: invalid command line
 */
export type ErrorCode =
  | 'invalid'
  | 'out-of-range'
  | 'unknown-name'
  | 'unreadable'
  | 'unwritable'
  | 'unsupported'
  | 'usage'

/** Parts of an error message. */
export interface ErrorParts {
  /** Default `invalid`. */
  code?: ErrorCode
  /** Class, function or command that the user called. */
  who: string
  /** The problem, as a phrase. */
  problem: string
  /** The rejected value. */
  value?: unknown
  /** The allowed values. */
  limit?: string | undefined
  /** How the user can fix the problem. */
  remedy: string
}

/** The package's only error class. Messages read `Module: problem, got VALUE, allowed: LIMIT; remedy`. */
export class FurrowError extends Error implements ErrorParts {
  override readonly name = 'FurrowError'
  declare readonly code: ErrorCode
  declare readonly who: string
  declare readonly problem: string
  readonly value: unknown
  readonly limit: string | undefined
  declare readonly remedy: string

  constructor(parts: ErrorParts, options?: ErrorOptions) {
    super(formatProblem(parts), options)
    Object.assign(this, parts, { code: parts.code ?? 'invalid' })
  }

  /** Returns a copy of this error that names `who`, so that users see the function that they called, not its helper. */
  reportedBy(who: string): FurrowError {
    return new FurrowError({ ...this, who }, { cause: this })
  }
}

/** Formats the message of an error or warning as one line. */
export function formatProblem({ who, problem, value, limit, remedy }: ErrorParts): string {
  const given = value === undefined ? '' : `, got ${printable(value)}`
  const allowed = limit === undefined ? '' : `, allowed: ${limit}`
  return `${who}: ${problem}${given}${allowed}; ${remedy}`
}

/** Formats a value in at most 120 characters. */
function printable(value: unknown): string {
  const isPlain = (typeof value !== 'object' || value === null) && typeof value !== 'string'
  const text = isPlain ? String(value) : (toJson(value) ?? 'an object')
  return text.length > 120 ? `${text.slice(0, 117)}...` : text
}

/** Returns undefined if the value cannot be serialised (cyclic, or nested too deeply). */
function toJson(value: unknown): string | undefined {
  try {
    return JSON.stringify(value)
  } catch {
    return undefined
  }
}
