/** The parts of every Furrow error, in the order they are read. */
export interface ErrorParts {
  /** Who complains: the class, function or command the caller used. */
  who: string
  /** What is wrong. */
  what: string
  /** The value that was given, as it should be printed. */
  value?: unknown
  /** What would have been accepted. */
  limit?: string
  /** What the caller can do about it. */
  remedy: string
}

/** The one error class of the package: `Module: what, the value, the limit, the remedy`. */
export class FurrowError extends Error {
  override readonly name = 'FurrowError'

  constructor(parts: ErrorParts) {
    super(sentence(parts))
  }
}

/** Prints one problem as one line, for errors and for warnings alike. */
export function sentence({ who, what, value, limit, remedy }: ErrorParts): string {
  const given = value === undefined ? '' : `, got ${printable(value)}`
  const allowed = limit === undefined ? '' : `, allowed: ${limit}`
  return `${who}: ${what}${given}${allowed}; ${remedy}`
}

function printable(value: unknown): string {
  const text = typeof value === 'string' ? JSON.stringify(value) : String(value)
  return text.length > 120 ? `${text.slice(0, 117)}...` : text
}
