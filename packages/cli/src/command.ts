import { Command, type CommanderError } from 'commander'
import { FurrowError } from 'furrow'
import { didYouMean } from 'furrow/internal'
import { forgetFilesRead } from 'furrow-files/node'

/**
 * Creates a command that throws `FurrowError` with the code `usage` for unknown options and for missing or invalid
 * arguments. Commander would print these errors and exit.
 *
 * @param name name of the command as the user types it, or `furrow` for the program itself.
 */
export function createCommand(name: string): Command {
  const who = name === 'furrow' ? name : `furrow ${name}`
  const command = new Command(name).configureOutput({ outputError: () => {} })
  command.hook('preAction', () => {
    forgetFilesRead()
    checkValues(command, who)
  })
  return command.exitOverride((error) => {
    // Commander has printed the help or the version.
    if (error.exitCode === 0 || error.code === 'commander.help') return
    throw usageError(command, who, error)
  })
}

/** Throws if an argument or option is an empty string, which usually comes from an unset variable in a script. */
function checkValues(command: Command, who: string): void {
  const given = [
    ...command.registeredArguments.map((argument, i) => [
      `argument '${argument.name()}'`,
      command.processedArgs[i],
    ]),
    ...command.options.map((option) => [
      `option '${option.flags}'`,
      command.getOptionValue(option.attributeName()),
    ]),
  ]
  const empty = given.find(([, value]) => [value].flat().includes(''))
  if (!empty) return
  throw new FurrowError({
    code: 'usage',
    who,
    problem: `${empty[0]} is empty`,
    remedy: `give it a value; see ${who} --help`,
  })
}

function usageError(command: Command, who: string, error: CommanderError): FurrowError {
  const { problem, suggestion } = readMessage(error)
  const toError = (problem: string, remedy: string) =>
    new FurrowError({ code: 'usage', who, problem, remedy }, { cause: error })
  const help = `see ${who} --help`
  // If a required option is misspelt, commander reports it as missing. An error about the unknown option helps more.
  const unknown = error.code === 'commander.missingMandatoryOptionValue' ? unknownOption(command) : undefined
  if (unknown !== undefined) {
    const options = command.options.flatMap(({ long }) => long ?? [])
    return toError(`unknown option '${unknown}'`, didYouMean(unknown, options, help))
  }
  // Commander suggests similar commands and options, but not similar values of an option with fixed choices.
  if (suggestion) return toError(problem, `did you mean "${suggestion}"?`)
  const choice = /argument '(.*)' is invalid\. Allowed choices are (.*)$/.exec(problem)
  if (!choice) return toError(problem, help)
  // An option with several values takes all following words as values, even words that are meant as file names.
  const fallback = problem.includes('...>') ? `put files before this option; ${help}` : help
  return toError(problem, didYouMean(choice[1], choice[2].split(', '), fallback))
}

/**
 * Parses commander's message. It is `error: PROBLEM`, optionally a full stop, and optionally a second line with a
 * suggestion.
 */
function readMessage({ message }: CommanderError): { problem: string; suggestion: string | undefined } {
  const [first, second = ''] = message.split('\n')
  const problem = first.replace(/^error: /, '').replace(/\.$/, '')
  return { problem, suggestion: /^\(Did you mean (.*)\?\)$/.exec(second)?.[1] }
}

function unknownOption(command: Command): string | undefined {
  const { rawArgs = [] } = (command.parent ?? command) as Command & { rawArgs?: string[] }
  return rawArgs.find((text) => {
    return text.startsWith('--') && !command.options.some(({ long }) => long === text.split('=')[0])
  })
}
