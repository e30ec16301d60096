import type { Printed } from '../../print.ts'

/** Message to a job process. */
export interface CommandRequest {
  command: string
  /** Command-line arguments after the command. */
  words: string[]
}

/** Message from a job process: the result of a command. */
export interface CommandReport extends Printed {
  exitCode: number
  /** Error, one line. */
  failure?: string
  /** Whether the machine caused the failure: a file cannot be written. */
  isMachine?: boolean
  /** Whether the failure is a bug of this program. The process is then not reused. */
  isBug?: boolean
  /** Memory of the process after the command, bytes. */
  memory: number
}

/** Task of the thread that watches a process. */
export interface WatchTask {
  /** Memory limit of the process, bytes. */
  memory: number
  /** Id of the parent. The process is killed if its parent has ended. */
  parent: number
}

/** Message on stderr before a process is killed at its memory limit. */
export const OVER_MEMORY = 'furrow: over the memory limit'
