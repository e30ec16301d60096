import { InvalidArgumentError, Option } from 'commander'

export interface NumberRule {
  min: number
  max: number
  /** Unit that errors print after the range, e.g. `mm`. */
  unit?: string
  integer?: boolean
}

export function numberParser({ min, max, unit = '', integer = false }: NumberRule): (text: string) => number {
  return (text) => {
    const value = text.trim() === '' ? Number.NaN : Number(text)
    if (value >= min && value <= max && (!integer || Number.isInteger(value))) return value
    const range = `${min} to ${max}${unit && ` ${unit}`}`
    throw new InvalidArgumentError(`It must be ${integer ? 'an integer' : 'a number'} from ${range}.`)
  }
}

/**
 * Returns a parser for an option that takes several `NAME=VALUE`. The parser collects the values by name.
 *
 * @param range inclusive range of the values. Default: any finite number.
 */
export function assignmentParser({ min = -Number.MAX_VALUE, max = Number.MAX_VALUE } = {}) {
  const values = Number.isFinite(max - min) ? `a value from ${min} to ${max}` : 'a finite value'
  return (text: string, collected: Record<string, number> = {}): Record<string, number> => {
    const at = text.lastIndexOf('=')
    const [name, number] = [text.slice(0, at), text.slice(at + 1).trim()]
    const value = number === '' ? Number.NaN : Number(number)
    if (at > 0 && value >= min && value <= max) return { ...collected, [name]: value }
    // Such an option takes all following words as values, also file names.
    throw new InvalidArgumentError(`It must be NAME=VALUE with ${values}; put files before this option.`)
  }
}

/** Parses `NAME=VALUE` with a weight or an activation from 0 to 1. */
export const parseWeight = assignmentParser({ min: 0, max: 1 })

/** Returns the option `--force`, for commands whose output can have the format of an input. */
export function forceOption(): Option {
  return new Option('--force', 'allow the output to overwrite the input')
}

/** Returns the option `--allow-outside`, for commands that read glTF. See `ReadOptions`. */
export function allowOutsideOption(): Option {
  return new Option('--allow-outside', 'allow the file to reference files outside its folder')
}
