import { createHash } from 'node:crypto'
import type { JobCommandName } from './job-commands.ts'
import type { JobOptions } from './job-options.ts'

/** A command on one input, as plain data that a queue can store. */
export interface Job {
  /** Hash of everything that determines the result, see `keyOf`. Does not depend on the paths of input and output. */
  key: string
  command: JobCommandName
  input: string
  /** Content identity of the input, see `FileStore.identify`. */
  identity: string
  /** Path or URL. Absent for commands that write no file. */
  output?: string
  options: JobOptions
}

/**
 * Cause of a failure. `file`: the input or the options are invalid, so the job would fail again. `memory` and `time`: a
 * limit was exceeded. `crash`: the process crashed. `machine`: the disk or the network failed.
 */
export type FailureKind = 'file' | 'memory' | 'time' | 'crash' | 'machine'

/** Result of a job that has ended. */
export interface Outcome {
  status: 'done' | 'failed'
  /** Reason of the failure, one line. `reason` and `kind` are absent if the job succeeded. */
  reason?: string
  kind?: FailureKind
  warnings: string[]
  /** Fields of the JSON that the command printed, see `JobCommand.summary`. */
  result?: Record<string, unknown>
  /** Size of the output, bytes. */
  bytes?: number
  seconds: number
  attempts: number
  /** Resident memory of the process after the command, bytes. */
  memory?: number
}

/**
 * Returns the key of a job: a hash of everything that determines its result.
 *
 * @param version version of this package.
 * @param options options, with content identities in place of file paths.
 */
export function keyOf(
  version: string,
  { command, identity, options }: Pick<Job, 'command' | 'identity' | 'options'>,
): string {
  const sorted = Object.entries(options).sort(([a], [b]) => (a < b ? -1 : 1))
  const text = JSON.stringify([version, command, identity, sorted])
  return createHash('sha256').update(text).digest('hex').slice(0, 32)
}
