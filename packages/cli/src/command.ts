import { Command, type CommanderError } from 'commander'
import { FurrowError } from 'furrow'
import { didYouMean } from 'furrow/internal'
import { forgetFilesRead } from 'furrow-files/node'

/**
 * A command whose errors are thrown as `FurrowError`, those of commander (unknown options, missing or wrong
 * arguments) with the code `usage`; nothing is printed and the process goes on.
 *
 * @param name as the user types it; `furrow` is the program itself.
 */
export function createCommand(name: string): Command {
  const who = name === 'furrow' ? name : `furrow ${name}`
  const command = new Command(name).configureOutput({ outputError: () => {} })
  command.hook('preAction', () => {
    forgetFilesRead()
    checkValues(command, who)
  })
  return command.exitOverride((error) => {
    // Help and version were printed; commander then exits by itself.
    if (error.exitCode === 0 || error.code === 'commander.help') return
    throw usageError(command, who, error)
  })
}

/** An empty path or name is a variable of a script that is not set. Throws FurrowError where there is one. */
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
  const fault = (problem: string, remedy: string) =>
    new FurrowError({ code: 'usage', who, problem, remedy }, { cause: error })
  const help = `see ${who} --help`
  // A required option that is misspelt is not missing.
  const unknown = error.code === 'commander.missingMandatoryOptionValue' ? unknownOption(command) : undefined
  if (unknown !== undefined) {
    const options = command.options.flatMap(({ long }) => long ?? [])
    return fault(`unknown option '${unknown}'`, didYouMean(unknown, options, help))
  }
  // Commander knows the nearest command and option, but not the nearest choice.
  if (suggestion) return fault(problem, `did you mean "${suggestion}"?`)
  const choice = /argument '(.*)' is invalid\. Allowed choices are (.*)$/.exec(problem)
  if (!choice) return fault(problem, help)
  // An option that takes several values takes a file behind it as one more.
  const otherwise = problem.includes('...>') ? `files go before this option; ${help}` : help
  return fault(problem, didYouMean(choice[1], choice[2].split(', '), otherwise))
}

/** Messages begin with `error: `; those about choices end with a full stop. A suggestion has a line of its own. */
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
