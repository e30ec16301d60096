import { readFileSync } from 'node:fs'
import { FurrowError } from 'furrow'
import { createCommand } from './command.ts'
import { activationsCommand } from './commands/activations.ts'
import { arrayCommand } from './commands/array.ts'
import { autoCommand } from './commands/auto.ts'
import { bakeCommand } from './commands/bake.ts'
import { inspectCommand } from './commands/inspect.ts'
import { normalsCommand } from './commands/normals.ts'
import { packCommand } from './commands/pack.ts'
import { renderCommand } from './commands/render.ts'
import { strokesCommand } from './commands/strokes.ts'
import { unpackCommand } from './commands/unpack.ts'
import { uvCommand } from './commands/uv.ts'
import { validateCommand } from './commands/validate.ts'
import { firstLine } from './errors.ts'

const { version } = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8'))

const program = createCommand('furrow')
  .description('Wrinkles for glTF characters: author, render and inspect them')
  .version(version, '-v, --version')
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
  inspectCommand,
  normalsCommand,
  packCommand,
  renderCommand,
  strokesCommand,
  unpackCommand,
  uvCommand,
  validateCommand,
]) {
  program.addCommand(command)
}

try {
  await program.parseAsync()
} catch (error) {
  // Users get one line; anything else is a bug, and gets a stack.
  console.error(error instanceof FurrowError ? firstLine(error) : error)
  process.exitCode = 1
}
