import { createHash } from 'node:crypto'
import type { JobCommandName } from './job-commands.ts'
import type { JobOptions } from './job-options.ts'

/** One command on one input, as plain data for a queue. */
export interface Job {
  /** Hash of the work, independent of the paths of input and output; see `keyOf`. */
  key: string
  command: JobCommandName
  input: string
  /** Content identity of the input; see `FileStore.identify`. */
  identity: string
  /** Absent for commands that write no file. */
  output?: string
  options: JobOptions
}

/**
 * Cause of a failure. `file`: the input or the options, so the same job fails again. `memory`, `time`: a limit.
 * `crash`: the process. `machine`: the disk or the network.
 */
export type FailureKind = 'file' | 'memory' | 'time' | 'crash' | 'machine'

/** Outcome of a job. */
export interface Outcome {
  status: 'done' | 'failed'
  /** Reason of a failure, one line; absent unless failed, like `kind`. */
  reason?: string
  kind?: FailureKind
  warnings: string[]
  /** Summary of the JSON that the command printed. */
  result?: Record<string, unknown>
  /** Size of the output, bytes. */
  bytes?: number
  seconds: number
  attempts: number
  /** Memory of the process after the command, bytes. */
  memory?: number
}

/**
 * Returns the key of a job: a hash of everything that determines its output.
 *
 * @param version version of this package.
 * @param options options, with content identities instead of file paths.
 */
export function keyOf(
  version: string,
  { command, identity, options }: Pick<Job, 'command' | 'identity' | 'options'>,
): string {
  const sorted = Object.entries(options).sort(([a], [b]) => (a < b ? -1 : 1))
  const text = JSON.stringify([version, command, identity, sorted])
  return createHash('sha256').update(text).digest('hex').slice(0, 32)
}
