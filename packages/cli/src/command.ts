import { Command, type CommanderError } from 'commander'
import { FurrowError } from 'furrow'
import { didYouMean } from './nearest.ts'

/**
 * A command whose errors are thrown as `FurrowError`, those of commander (unknown options, missing or wrong
 * arguments) with the code `usage`; nothing is printed and the process goes on.
 *
 * @param name as the user types it; `furrow` is the program itself.
 */
export function createCommand(name: string): Command {
  const who = name === 'furrow' ? name : `furrow ${name}`
  return new Command(name).configureOutput({ outputError: () => {} }).exitOverride((error) => {
    // Help and version were printed; commander then exits by itself.
    if (error.exitCode === 0 || error.code === 'commander.help') return
    throw usageError(who, error)
  })
}

/** Commander's messages begin with `error: `; those about choices end with a full stop. A suggestion has its own line. */
function usageError(who: string, error: CommanderError): FurrowError {
  const [first, suggestion] = error.message.split('\n')
  const what = first.replace(/^error: /, '').replace(/\.$/, '')
  return new FurrowError(
    { code: 'usage', who, what, remedy: remedyOf(who, what, suggestion) },
    { cause: error },
  )
}

function remedyOf(who: string, what: string, suggestion: string | undefined): string {
  const help = `see ${who} --help`
  // Commander knows the nearest command and option, but not the nearest choice.
  const similar = /^\(Did you mean (.*)\?\)$/.exec(suggestion ?? '')
  if (similar) return `did you mean ${similar[1]}?`
  const choice = /argument '(.*)' is invalid\. Allowed choices are (.*)$/.exec(what)
  return choice ? didYouMean(choice[1], choice[2].split(', '), help) : help
}
