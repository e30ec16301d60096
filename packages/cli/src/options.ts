import { InvalidArgumentError, Option } from 'commander'

/** Rule for a number on the command line. */
export interface NumberRule {
  min: number
  max: number
  /** Unit printed after the range, e.g. `mm`. */
  unit?: string
  integer?: boolean
}

/** Returns a parser of numbers in a range, for `Option.argParser`. */
export function numberParser({ min, max, unit = '', integer = false }: NumberRule): (text: string) => number {
  return (text) => {
    const value = text.trim() === '' ? Number.NaN : Number(text)
    if (value >= min && value <= max && (!integer || Number.isInteger(value))) return value
    const range = `${min} to ${max}${unit && ` ${unit}`}`
    throw new InvalidArgumentError(`It must be ${integer ? 'an integer' : 'a number'} from ${range}.`)
  }
}

/**
 * Returns a parser for options with several `NAME=VALUE`, which collects the values by name.
 *
 * @param range inclusive range of the values, default any finite number.
 */
export function assignmentParser({ min = -Number.MAX_VALUE, max = Number.MAX_VALUE } = {}) {
  const values = Number.isFinite(max - min) ? `a value from ${min} to ${max}` : 'a finite value'
  return (text: string, collected: Record<string, number> = {}): Record<string, number> => {
    const at = text.lastIndexOf('=')
    const [name, number] = [text.slice(0, at), text.slice(at + 1).trim()]
    const value = number === '' ? Number.NaN : Number(number)
    if (at > 0 && value >= min && value <= max) return { ...collected, [name]: value }
    // Without `--` such an option also consumes a file name that follows it.
    throw new InvalidArgumentError(`It must be NAME=VALUE with ${values}; put files before this option.`)
  }
}

/** Parses `NAME=VALUE` of weights or activations, 0..1. */
export const parseWeight = assignmentParser({ min: 0, max: 1 })

/** Returns the `--force` option, for commands whose output can have the format of an input; see `OutputRules`. */
export function forceOption(): Option {
  return new Option('--force', 'allow the output to overwrite the input')
}

/** Returns the `--allow-outside` option, for commands that read glTF; see `ReadOptions`. */
export function allowOutsideOption(): Option {
  return new Option('--allow-outside', 'allow references to files outside the folder')
}
