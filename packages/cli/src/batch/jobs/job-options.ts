import { FurrowError } from 'furrow'
import { createCommand } from '../../command.ts'
import { type JobCommandName, passedOptions } from './job-commands.ts'

/** Options of a command by name, without leading dashes. The value is `true` for an option without a value. */
export type JobOptions = Readonly<Record<string, true | string | readonly string[]>>

export function wordsOf(options: JobOptions): string[] {
  return Object.entries(options).flatMap(([name, value]) => [
    `--${name}`,
    ...(value === true ? [] : [value].flat()),
  ])
}

/**
 * Parses and validates the options of a job. Normalises their order and form, so that the same options always have the
 * same JSON.
 *
 * @param words command-line arguments.
 * @returns the given options, without defaults.
 * @throws FurrowError if an option is unknown or its value is invalid.
 */
export function parseJobOptions(command: JobCommandName, words: readonly string[]): JobOptions {
  const parser = createCommand('batch').allowExcessArguments(false)
  for (const option of passedOptions(command)) parser.addOption(option)
  parser.action(() => {}).parse([...words], { from: 'user' })
  return givenOptions(parser)
}

type Parser = ReturnType<typeof createCommand>

/**
 * Returns the options that a user gave to a parsed command, without defaults.
 *
 * @param only limits the result to these options. Default: all options of the command.
 */
export function givenOptions(parser: Parser, only = parser.options): JobOptions {
  const given = only.filter((option) => parser.getOptionValueSource(option.attributeName()) === 'cli')
  const pairs = given.map((option) => {
    const value: unknown = parser.getOptionValue(option.attributeName())
    const text = Array.isArray(value) ? value.map(String) : value === true ? true : String(value)
    return [option.name(), text] as const
  })
  return Object.fromEntries(pairs.sort(([a], [b]) => (a < b ? -1 : 1)))
}

/**
 * Converts the options in a line of a manifest to command-line arguments. A value is text, a number, a boolean, or a
 * list of text and numbers.
 */
export function manifestWords(options: unknown, where: string): string[] {
  const isObject = typeof options === 'object' && options !== null && !Array.isArray(options)
  const entries = isObject ? Object.entries(options) : []
  const isWord = (value: unknown) => typeof value === 'string' || typeof value === 'number'
  const invalid = entries.find(([, value]) => typeof value !== 'boolean' && ![value].flat().every(isWord))
  if (!isObject || invalid) {
    throw new FurrowError({
      who: 'furrow batch',
      problem: `${where}: ${invalid ? `invalid value of the option ${invalid[0]}` : '"options" is not an object'}`,
      value: invalid ? invalid[1] : options,
      limit: '{ "age": 40, "furrows": true, "regions": ["neck", "chin"] }, names as on the command line',
      remedy: 'correct the line',
    })
  }
  const chosen = entries.filter(([, value]) => value !== false)
  return wordsOf(
    Object.fromEntries(
      chosen.map(([name, value]) => [
        name,
        value === true ? true : Array.isArray(value) ? value.map(String) : String(value),
      ]),
    ),
  )
}
