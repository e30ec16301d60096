import { availableParallelism, totalmem } from 'node:os'
import { Option } from 'commander'
import { numberParser } from '../options.ts'
import type { ProcessLimits } from './processes/process-pool.ts'

const MB = 2 ** 20

/** Default limits of a job, bytes and seconds. */
const DEFAULT_MEMORY = 4096 * MB
const DEFAULT_SECONDS = 600

/** Options of the commands that run jobs on this machine. */
export interface LimitOptions {
  jobs?: number
  memory?: number
  timeout?: number
}

export const LIMIT_OPTIONS: readonly Option[] = [
  new Option('--jobs <count>', 'parallel jobs, 1 to 1024 (default: one per core)').argParser(
    numberParser({ min: 1, max: 1024, integer: true }),
  ),
  new Option(
    '--memory <MB>',
    `memory limit of a job, from 256 (default: up to ${DEFAULT_MEMORY / MB})`,
  ).argParser(numberParser({ min: 256, max: 2 ** 20, unit: 'MB', integer: true })),
  new Option(
    '--timeout <seconds>',
    `time limit of a job, 1 to 86400 (default: ${DEFAULT_SECONDS})`,
  ).argParser(numberParser({ min: 1, max: 86_400, unit: 'seconds' })),
]

/** Returns the number of parallel jobs on this machine and the limits of each. */
export function limitsOf({ jobs, memory, timeout }: LimitOptions): {
  concurrency: number
  limits: ProcessLimits
} {
  const concurrency = jobs ?? availableParallelism()
  // A container may have less than the machine. Without a limit, some systems report an enormous number.
  const machine = Math.min(totalmem(), process.constrainedMemory() || totalmem())
  const share = Math.max(256 * MB, Math.floor(machine / concurrency))
  return {
    concurrency,
    limits: {
      memory: memory === undefined ? Math.min(DEFAULT_MEMORY, share) : memory * MB,
      seconds: timeout ?? DEFAULT_SECONDS,
    },
  }
}
