// Child process of `ProcessPool`. Runs the commands that it receives as messages, one at a time.

import { inspect } from 'node:util'
import { FurrowError } from 'furrow'
import { firstLine } from 'furrow-files'
import { capturePrinted, type Printed } from '../../print.ts'
import { isJobCommand, JOB_COMMANDS } from '../jobs/job-commands.ts'
import type { CommandReport, CommandRequest } from './protocol.ts'
import { startWatch } from './watch.ts'

const [, , memory] = process.argv
startWatch({ memory: Number(memory), parent: process.ppid })

process.on('message', async (request: CommandRequest) => {
  process.send!(await run(request))
})
process.on('disconnect', () => process.exit())

async function run({ command, words }: CommandRequest): Promise<CommandReport> {
  const printed: Printed = { lines: [], warnings: [] }
  const failure = await capturePrinted(printed, async () => {
    if (!isJobCommand(command)) throw new Error(`unknown command ${command}`)
    await JOB_COMMANDS[command].command.parseAsync(words, { from: 'user' })
  }).then(
    () => undefined,
    (error) => error,
  )
  const exitCode = failure ? 1 : Number(process.exitCode ?? 0)
  process.exitCode = 0
  const isBug = failure !== undefined && !(failure instanceof FurrowError)
  if (isBug) console.error(inspect(failure))
  return {
    ...printed,
    exitCode,
    ...(failure && { failure: firstLine(failure) }),
    isBug,
    isMachine: failure instanceof FurrowError && failure.code === 'unwritable',
    memory: process.memoryUsage.rss(),
  }
}
