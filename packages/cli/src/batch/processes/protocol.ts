import type { Printed } from '../../print.ts'

/** Message to the child process that runs commands. */
export interface CommandRequest {
  command: string
  /** Command-line arguments after the name of the command. */
  words: string[]
}

/** Message from the child process: the result of a command. */
export interface CommandReport extends Printed {
  exitCode: number
  /** Error message, one line. */
  failure?: string
  /** Whether the failure is due to the machine: a file could not be written. */
  isMachine?: boolean
  /** Whether the failure is a bug of this program. The process is then not reused. */
  isBug?: boolean
  /** Resident memory of the process after the command, bytes. */
  memory: number
}

/** Input of the thread that watches the memory and the parent of a process. */
export interface WatchTask {
  /** Memory limit of the process, bytes. */
  memory: number
  /** Process id of the parent. The process is killed when its parent has ended. */
  parent: number
}

/** Text that a process writes to stderr before it kills itself at its memory limit. */
export const OVER_MEMORY = 'furrow: over the memory limit'
