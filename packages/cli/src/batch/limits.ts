import { availableParallelism, totalmem } from 'node:os'
import { Option } from 'commander'
import { numberParser } from '../options.ts'
import type { ProcessLimits } from './processes/process-pool.ts'

const MB = 2 ** 20

/** Default limits of a job, in bytes and seconds. */
const DEFAULT_MEMORY = 4096 * MB
const DEFAULT_SECONDS = 600

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
    `memory limit of a job, at least 256 (default: equal shares, up to ${DEFAULT_MEMORY / MB})`,
  ).argParser(numberParser({ min: 256, max: 2 ** 20, unit: 'MB', integer: true })),
  new Option(
    '--timeout <seconds>',
    `time limit of a job, 1 to 86400 (default: ${DEFAULT_SECONDS})`,
  ).argParser(numberParser({ min: 1, max: 86_400, unit: 'seconds' })),
]

export function limitsOf({ jobs, memory, timeout }: LimitOptions): {
  concurrency: number
  limits: ProcessLimits
} {
  const concurrency = jobs ?? availableParallelism()
  // A container may have less memory than the machine. Some systems report a huge number if a container has no limit.
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
