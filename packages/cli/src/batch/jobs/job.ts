import { createHash } from 'node:crypto'
import type { JobCommandName } from './job-commands.ts'
import type { JobOptions } from './job-options.ts'

/** One input, what to do with it, and where the result goes: plain data, which a queue can hold. */
export interface Job {
  /** The same for the same work, wherever the input lies and the output goes; see `keyOf`. */
  key: string
  command: JobCommandName
  input: string
  /** What stands for the content of the input; see `Place.identify`. */
  identity: string
  /** Absent where the command makes no file. */
  output?: string
  options: JobOptions
}

/**
 * What failed: the input or the options, for which the same job fails again; a limit of memory or time; the process; the
 * machine, its disk or its network.
 */
export type FailureKind = 'file' | 'memory' | 'time' | 'crash' | 'machine'

/** What came of a job. */
export interface Outcome {
  status: 'done' | 'failed'
  /** In one line; of those that failed alone, like `kind`. */
  reason?: string
  kind?: FailureKind
  warnings: string[]
  /** What the command printed as JSON, in short. */
  result?: Record<string, unknown>
  /** Of the output. */
  bytes?: number
  seconds: number
  attempts: number
  /** Bytes of memory that its process held at the end. */
  memory?: number
}

/**
 * The key of a job: what its output follows from.
 *
 * @param version of this package.
 * @param options with the content of files in place of their paths.
 */
export function keyOf(
  version: string,
  { command, identity, options }: Pick<Job, 'command' | 'identity' | 'options'>,
): string {
  const sorted = Object.entries(options).sort(([a], [b]) => (a < b ? -1 : 1))
  const text = JSON.stringify([version, command, identity, sorted])
  return createHash('sha256').update(text).digest('hex').slice(0, 32)
}
