import type { Printed } from '../../print.ts'

/** What Node's main process and the process of a job tell each other: plain data. */
export interface CommandRequest {
  command: string
  /** As on the command line, behind the command. */
  words: string[]
}

/** How a command ended. */
export interface CommandReport extends Printed {
  exitCode: number
  /** Why it failed, in one line. */
  failure?: string
  /** Whether the machine is to blame: a file cannot be written. */
  isMachine?: boolean
  /** Whether that is a fault of this program rather than of the file: the process is not used again. */
  isBug?: boolean
  /** Bytes of memory that the process holds after the command. */
  memory: number
}

/** What the watch of a process gets. */
export interface WatchTask {
  /** Bytes of memory beyond which the process is ended. */
  memory: number
  /** The process that ended must not leave this one behind. */
  parent: number
}

/** What the watch writes to stderr before it ends a process for its memory. */
export const OVER_MEMORY = 'furrow: over the memory limit'
