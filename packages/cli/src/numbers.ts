import { FurrowError } from 'furrow'

/** What a number on the command line may be. */
export interface NumberRule {
  low: number
  high: number
  /** Unit for the error, e.g. `mm`. */
  unit?: string
  whole?: boolean
  /** A value that would do, for the remedy. */
  example: number
}

/** Reads a number of the command line. Throws FurrowError naming the option where it is none or out of range. */
export function readNumber(who: string, option: string, text: string, rule: NumberRule): number {
  const { low, high, unit = '', whole = false, example } = rule
  const value = text.trim() === '' ? Number.NaN : Number(text)
  if (value >= low && value <= high && (!whole || Number.isInteger(value))) return value
  throw new FurrowError({
    who,
    what: `${option} is no ${whole ? 'whole ' : ''}number in its range`,
    value: text,
    limit: `${low}..${high}${unit && ` ${unit}`}`,
    remedy: `write e.g. ${option} ${example}`,
  })
}

/** Reads one word of a list. Throws FurrowError naming the option where it is another. */
export function readChoice<T extends string>(
  who: string,
  option: string,
  text: string,
  allowed: readonly T[],
): T {
  if (allowed.includes(text as T)) return text as T
  throw new FurrowError({
    who,
    what: `${option} is unknown`,
    value: text,
    limit: allowed.join(', '),
    remedy: `write e.g. ${option} ${allowed[0]}`,
  })
}
