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

/** Reads `name=weight`, 0..1, for an option that takes several. Throws FurrowError where it is not one. */
export function weightCollector(who: string) {
  return collector((value) => value >= 0 && value <= 1, {
    who,
    what: 'no weight',
    limit: 'NAME=0 to NAME=1',
    remedy: 'write e.g. --set jawOpen=0.5; files go before these options',
  })
}

/** Reads `name=value`, any finite number, for an option that takes several. Throws FurrowError where it is not one. */
export function inputCollector(who: string) {
  return collector(Number.isFinite, {
    who,
    what: 'no input',
    limit: 'NAME=NUMBER',
    remedy: 'write e.g. --input age=50; files go before these options',
  })
}

function collector(
  isValid: (value: number) => boolean,
  error: { who: string; what: string; limit: string; remedy: string },
) {
  return (text: string, before: Record<string, number> = {}): Record<string, number> => {
    const at = text.lastIndexOf('=')
    const [name, number] = [text.slice(0, at), text.slice(at + 1).trim()]
    const value = number === '' ? Number.NaN : Number(number)
    if (at > 0 && isValid(value)) return { ...before, [name]: value }
    throw new FurrowError({ ...error, value: text })
  }
}
