import { InvalidArgumentError, Option } from 'commander'

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

/**
 * A parser for options that take several `NAME=VALUE`; gathers them by name.
 *
 * @param min, max of the values; any finite number by default.
 */
export function assignmentParser({ min = -Number.MAX_VALUE, max = Number.MAX_VALUE } = {}) {
  const values = Number.isFinite(max - min) ? `a value from ${min} to ${max}` : 'a finite value'
  return (text: string, gathered: Record<string, number> = {}): Record<string, number> => {
    const at = text.lastIndexOf('=')
    const [name, number] = [text.slice(0, at), text.slice(at + 1).trim()]
    const value = number === '' ? Number.NaN : Number(number)
    if (at > 0 && value >= min && value <= max) return { ...gathered, [name]: value }
    // Without `--` such an option takes a file name behind it as another value.
    throw new InvalidArgumentError(`It must be NAME=VALUE with ${values}; files go before this option.`)
  }
}

/** Parses `NAME=VALUE` of a weight or activation, 0..1. */
export const parseWeight = assignmentParser({ min: 0, max: 1 })

/** The option of commands whose output may be of the same kind as an input; see `OutputRules`. */
export function forceOption(): Option {
  return new Option('--force', 'let the output replace the input')
}

/** The option of commands that read glTF; see `ReadOptions`. */
export function allowOutsideOption(): Option {
  return new Option('--allow-outside', 'let a file refer to files outside its own folder')
}
