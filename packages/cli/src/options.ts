import { InvalidArgumentError } from 'commander'

/** What a number on the command line may be. */
export interface NumberRule {
  min: number
  max: number
  /** Printed after the range, e.g. `mm`. */
  unit?: string
  integer?: boolean
}

/** A parser for `Option.argParser` of numbers in a range. */
export function numberParser({ min, max, unit = '', integer = false }: NumberRule): (text: string) => number {
  return (text) => {
    const value = text.trim() === '' ? Number.NaN : Number(text)
    if (value >= min && value <= max && (!integer || Number.isInteger(value))) return value
    const range = `${min} to ${max}${unit && ` ${unit}`}`
    throw new InvalidArgumentError(`It must be ${integer ? 'an integer' : 'a number'} from ${range}.`)
  }
}

/** A parser for an option that takes several `NAME=VALUE`, values 0..1; gathers them by name. */
export function parseWeight(text: string, gathered: Record<string, number> = {}): Record<string, number> {
  const at = text.lastIndexOf('=')
  const [name, number] = [text.slice(0, at), text.slice(at + 1).trim()]
  const value = number === '' ? Number.NaN : Number(number)
  if (at > 0 && value >= 0 && value <= 1) return { ...gathered, [name]: value }
  // An option that takes several values also takes a file name behind them.
  throw new InvalidArgumentError(
    'It must be NAME=VALUE with a value from 0 to 1; files go before this option.',
  )
}
