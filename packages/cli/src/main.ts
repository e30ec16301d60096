import { readFileSync } from 'node:fs'
import { Command } from 'commander'
import { FurrowError } from 'furrow'
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
import { validateCommand } from './commands/validate.ts'
import { firstLine } from './images.ts'

const { version } = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8'))

const program = new Command('furrow')
  .description('Wrinkles for glTF characters: author them, and see them')
  .version(version, '-v, --version')
  .showSuggestionAfterError(false)
  .addHelpText(
    'after',
    `
Examples:
  $ furrow render faces/human.glb -o surprised.png --expression surprised
  $ furrow strokes faces/human/strokes.json --face faces/human.glb --normal wrinkled.png --areas areas
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
  validateCommand,
]) {
  program.addCommand(command.copyInheritedSettings(program))
}
for (const command of [program, ...program.commands]) {
  command.configureOutput({
    outputError: (text, write) =>
      write(`furrow: ${text.trim().replace(/^error: /, '')}; see furrow --help\n`),
  })
}

try {
  await program.parseAsync()
} catch (error) {
  // What users can mend is one line; anything else is a fault of ours, and says where it is.
  console.error(error instanceof FurrowError ? firstLine(error) : error)
  process.exitCode = 1
}
