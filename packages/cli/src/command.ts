import { Command, type CommanderError } from 'commander'
import { FurrowError } from 'furrow'

/**
 * A command whose errors are thrown as `FurrowError`, those of commander (unknown options, missing or wrong
 * arguments) with the code `usage`; nothing is printed and the process goes on.
 *
 * @param name as the user types it; `furrow` is the program itself.
 */
export function createCommand(name: string): Command {
  const who = name === 'furrow' ? name : `furrow ${name}`
  return new Command(name)
    .showSuggestionAfterError(false)
    .configureOutput({ outputError: () => {} })
    .exitOverride((error) => {
      // Help and version were printed; commander then exits by itself.
      if (error.exitCode === 0 || error.code === 'commander.help') return
      throw usageError(who, error)
    })
}

/** Commander's messages begin with `error: `; those about choices end with a full stop. */
function usageError(who: string, error: CommanderError): FurrowError {
  const what = error.message.replace(/^error: /, '').replace(/\.$/, '')
  return new FurrowError({ code: 'usage', who, what, remedy: `see ${who} --help` }, { cause: error })
}
