// `run-command NAME ARGUMENTS` runs one `furrow` command and prints its processor time, peak memory and error as JSON.

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
  /** Error name and message; absent on success. */
  error?: { name: string; message: string }
  /** Peak resident memory, megabytes. */
  megabytes: number
  /** Processor time, seconds. */
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
// `furrow validate` sets exit code 1 for findings, which are no failure here.
process.exitCode = 0
