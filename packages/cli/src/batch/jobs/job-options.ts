import { FurrowError } from 'furrow'
import { createCommand } from '../../command.ts'
import { type JobCommandName, passedOptions } from './job-commands.ts'

/** Options of a job by their command-line names, without dashes; true for options without a value. */
export type JobOptions = Readonly<Record<string, true | string | readonly string[]>>

/** Converts options to command-line arguments. */
export function wordsOf(options: JobOptions): string[] {
  return Object.entries(options).flatMap(([name, value]) => [
    `--${name}`,
    ...(value === true ? [] : [value].flat()),
  ])
}

/**
 * Validates the options of a job like its command, and normalises their order and form.
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

/** Returns the options given to a parsed command, without defaults; `only` limits the options. */
export function givenOptions(parser: Parser, only = parser.options): JobOptions {
  const given = only.filter((option) => parser.getOptionValueSource(option.attributeName()) === 'cli')
  const pairs = given.map((option) => {
    const value: unknown = parser.getOptionValue(option.attributeName())
    const text = Array.isArray(value) ? value.map(String) : value === true ? true : String(value)
    return [option.name(), text] as const
  })
  return Object.fromEntries(pairs.sort(([a], [b]) => (a < b ? -1 : 1)))
}

/** Converts the options in a manifest line to command-line arguments. Values: text, number, boolean, or a list of text. */
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
