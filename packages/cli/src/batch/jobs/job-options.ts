import { FurrowError } from 'furrow'
import { createCommand } from '../../command.ts'
import { type JobCommandName, passedOptions } from './job-commands.ts'

/** Options of a job by their names on the command line, without dashes: true for those without a value. */
export type JobOptions = Readonly<Record<string, true | string | readonly string[]>>

/** Options as words of a command line. */
export function wordsOf(options: JobOptions): string[] {
  return Object.entries(options).flatMap(([name, value]) => [
    `--${name}`,
    ...(value === true ? [] : [value].flat()),
  ])
}

/**
 * Checks the options of a job as its command would, and puts them in one order and form.
 *
 * @param words as on the command line.
 * @returns only those that were given: others are what the version of the command says.
 * @throws FurrowError when one is unknown or its value is not allowed.
 */
export function parseJobOptions(command: JobCommandName, words: readonly string[]): JobOptions {
  const parser = createCommand('batch').allowExcessArguments(false)
  for (const option of passedOptions(command)) parser.addOption(option)
  parser.action(() => {}).parse([...words], { from: 'user' })
  return givenOptions(parser)
}

type Parser = ReturnType<typeof createCommand>

/** The options of a command that was parsed, without defaults; `only` some of them. */
export function givenOptions(parser: Parser, only = parser.options): JobOptions {
  const given = only.filter((option) => parser.getOptionValueSource(option.attributeName()) === 'cli')
  const pairs = given.map((option) => {
    const value: unknown = parser.getOptionValue(option.attributeName())
    const text = Array.isArray(value) ? value.map(String) : value === true ? true : String(value)
    return [option.name(), text] as const
  })
  return Object.fromEntries(pairs.sort(([a], [b]) => (a < b ? -1 : 1)))
}

/** The words of the options in a line of a manifest: text, numbers, true, or lists of text by name. */
export function manifestWords(options: unknown, where: string): string[] {
  const isObject = typeof options === 'object' && options !== null && !Array.isArray(options)
  const entries = isObject ? Object.entries(options) : []
  const isWord = (value: unknown) => typeof value === 'string' || typeof value === 'number'
  const wrong = entries.find(([, value]) => typeof value !== 'boolean' && ![value].flat().every(isWord))
  if (!isObject || wrong) {
    throw new FurrowError({
      who: 'furrow batch',
      problem: `${where}: ${wrong ? `the option ${wrong[0]} has no such value` : '"options" is no object'}`,
      value: wrong ? wrong[1] : options,
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
