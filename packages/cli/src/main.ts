import { inspect } from 'node:util'
import { FurrowError } from 'furrow'
import { cannotWrite } from 'furrow-files'
import { batchCommand } from './batch/commands/batch.ts'
import { workerCommand } from './batch/commands/worker.ts'
import { createCommand } from './command.ts'
import { activationsCommand } from './commands/activations.ts'
import { arrayCommand } from './commands/array.ts'
import { autoCommand } from './commands/auto.ts'
import { bakeCommand } from './commands/bake.ts'
import { importCommand } from './commands/import.ts'
import { inspectCommand } from './commands/inspect.ts'
import { liveCommand } from './commands/live.ts'
import { normalsCommand } from './commands/normals.ts'
import { packCommand } from './commands/pack.ts'
import { renderCommand } from './commands/render.ts'
import { strokesCommand } from './commands/strokes.ts'
import { unpackCommand } from './commands/unpack.ts'
import { uvCommand } from './commands/uv.ts'
import { validateCommand } from './commands/validate.ts'
import { warn } from './print.ts'
import { version } from './version.ts'

const program = createCommand('furrow')
  .description('Author, render and inspect wrinkles for glTF characters')
  .version(version, '-v, --version')
  .addHelpText('before', helpOfCommand)
  .addHelpText(
    'after',
    `
Examples:
  $ furrow auto avatar.glb -o wrinkled.glb
  $ furrow render wrinkled.glb -o surprised.png --expression surprised
  $ furrow help render`,
  )

for (const command of [
  activationsCommand,
  arrayCommand,
  autoCommand,
  bakeCommand,
  batchCommand,
  importCommand,
  inspectCommand,
  liveCommand,
  normalsCommand,
  packCommand,
  renderCommand,
  strokesCommand,
  unpackCommand,
  uvCommand,
  validateCommand,
  workerCommand,
]) {
  program.addCommand(command)
}

/**
 * Prints the help of the command that follows `help`. If the command is unknown, `parse` throws an error with the most
 * similar name. Commander would print the general help in both cases.
 */
function helpOfCommand(): string {
  const name = program.args.find((text) => text !== 'help' && !text.startsWith('-'))
  program.commands.find((command) => command.name() === name)?.help()
  if (name !== undefined) program.parse([name], { from: 'user' })
  return ''
}

for (const stream of [process.stdout, process.stderr]) {
  stream.on('error', (error: NodeJS.ErrnoException) => {
    // The reader of the pipe, such as `head`, has closed it.
    if (error.code === 'EPIPE') process.exit()
    warn(cannotWrite('furrow', 'to stdout', error).message)
    process.exit(1)
  })
}

try {
  const words = process.argv.slice(2).join(' ')
  // Commander has no help for its own `help` command.
  if (words === '' || words === 'help help') program.outputHelp()
  else await program.parseAsync()
} catch (error) {
  // All other errors are bugs, so their stack trace is printed.
  if (error instanceof FurrowError) warn(error.message)
  else for (const line of inspect(error).split('\n')) warn(line)
  process.exitCode = 1
}
