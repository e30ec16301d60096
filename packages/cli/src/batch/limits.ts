import { availableParallelism, totalmem } from 'node:os'
import { Option } from 'commander'
import { numberParser } from '../options.ts'
import type { ProcessLimits } from './processes/process-pool.ts'

const MB = 2 ** 20

/** What a job takes at most by default, where the machine has it. */
const DEFAULT_MEMORY = 4096 * MB
const DEFAULT_SECONDS = 600

/** Options of what runs jobs on this machine. */
export interface LimitOptions {
  jobs?: number
  memory?: number
  timeout?: number
}

export const LIMIT_OPTIONS: readonly Option[] = [
  new Option('--jobs <count>', 'jobs at the same time (default: one per core)').argParser(
    numberParser({ min: 1, max: 1024, integer: true }),
  ),
  new Option(
    '--memory <MB>',
    `memory of one job, whose process is ended beyond it (default: ${DEFAULT_MEMORY / MB}, or its share of the machine)`,
  ).argParser(numberParser({ min: 256, max: 2 ** 20, unit: 'MB', integer: true })),
  new Option(
    '--timeout <seconds>',
    `time of one job, whose process is ended beyond it (default: ${DEFAULT_SECONDS})`,
  ).argParser(numberParser({ min: 1, max: 86_400, unit: 'seconds' })),
]

/** How many jobs run at the same time on this machine, and what each may take. */
export function limitsOf({ jobs, memory, timeout }: LimitOptions): { lanes: number; limits: ProcessLimits } {
  const lanes = jobs ?? availableParallelism()
  // Less than the machine where a container is given less. Without a limit some systems tell an enormous number.
  const machine = Math.min(totalmem(), process.constrainedMemory() || totalmem())
  const share = Math.max(256 * MB, Math.floor(machine / lanes))
  return {
    lanes,
    limits: {
      memory: memory === undefined ? Math.min(DEFAULT_MEMORY, share) : memory * MB,
      seconds: timeout ?? DEFAULT_SECONDS,
    },
  }
}
