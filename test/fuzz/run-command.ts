// Runs one command, `run-command NAME ARGUMENTS`, and prints what it cost and how it ended as JSON.

import { arrayCommand } from '../../packages/cli/src/commands/array.ts'
import { inspectCommand } from '../../packages/cli/src/commands/inspect.ts'
import { normalsCommand } from '../../packages/cli/src/commands/normals.ts'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../packages/cli/src/commands/strokes.ts'
import { unpackCommand } from '../../packages/cli/src/commands/unpack.ts'
import { validateCommand } from '../../packages/cli/src/commands/validate.ts'
import { peakMemory } from './peak-memory.ts'
import { quietly } from './quietly.ts'

export interface RunCost {
  /** The name and message of the error; absent where there was none. */
  error?: { name: string; message: string }
  /** Largest resident memory in megabytes. */
  megabytes: number
  /** Seconds of the processor. */
  seconds: number
}

const COMMANDS = [
  arrayCommand,
  inspectCommand,
  normalsCommand,
  packCommand,
  strokesCommand,
  unpackCommand,
  validateCommand,
]

const [name, ...parameters] = process.argv.slice(2)
const command = COMMANDS.find((candidate) => candidate.name() === name)!
const error = await quietly(() => command.parseAsync(parameters, { from: 'user' })).then(
  () => undefined,
  ({ name, message }: Error) => ({ name, message }),
)
const { userCPUTime, systemCPUTime } = process.resourceUsage()
const cost: RunCost = {
  ...(error && { error }),
  megabytes: Math.round(peakMemory() / 2 ** 20),
  seconds: (userCPUTime + systemCPUTime) / 1e6,
}
process.stdout.write(JSON.stringify(cost))
// Findings of `validate` are no failure here.
process.exitCode = 0
