import { type ChildProcess, fork } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { type CommandReport, type CommandRequest, OVER_MEMORY } from './protocol.ts'

const JOB_PROCESS = fileURLToPath(new URL('./job-process.js', import.meta.url))

/** What one job may take. */
export interface ProcessLimits {
  /** Bytes of memory, of the whole process. */
  memory: number
  seconds: number
}

/** How a process ended, or what its command reported. */
export type ProcessEnd =
  | { end: 'report'; report: CommandReport }
  | { end: 'memory' | 'time' }
  | { end: 'crash'; reason: string }

/** Processes keep compiled code from one job to the next, and are ended where they also keep more than this of their memory. */
const MOST_KEPT = 0.5

/**
 * V8's own threads, which compile and collect garbage, get in each other's way where every core has a job: without them a face takes a tenth
 * less of the processor, and two at a time are 1.86 times as fast as one, in place of 1.4. One alone takes 16% longer.
 */
const NO_THREADS = '--single-threaded'

/** Characters of what a process wrote to stderr that are kept. */
const LAST_WORDS = 4096

/**
 * Runs commands in processes of their own: a job can then be ended at a limit, and one that crashes costs itself alone. A
 * process is used again, since a warm one takes 40% less time for a face (compiled code).
 *
 * Pools of others, as looked at: Piscina has threads, BullMQ's sandbox no limits, and Tinypool, which can abort a task in a
 * process, measures JavaScript's heap alone, between tasks, and tells every end of a process as the same error.
 */
export class ProcessPool {
  readonly #limits: ProcessLimits
  readonly #program: string
  readonly #idle: ChildProcess[] = []
  readonly #all = new Set<ChildProcess>()

  constructor(limits: ProcessLimits, program = JOB_PROCESS) {
    this.#limits = limits
    this.#program = program
  }

  /** Runs a command in a process that does nothing else meanwhile. */
  run(request: CommandRequest): Promise<ProcessEnd> {
    const child = this.#idle.pop() ?? this.#start()
    return new Promise((resolve) => {
      let lastWords = ''
      let late = false
      const timer = setTimeout(() => {
        late = true
        child.kill('SIGKILL')
      }, this.#limits.seconds * 1000)
      const listen = (text: Buffer) => {
        lastWords = `${lastWords}${text}`.slice(-LAST_WORDS)
      }
      const finish = (end: ProcessEnd) => {
        clearTimeout(timer)
        child.stderr!.off('data', listen)
        child.off('message', onReport).off('close', onEnd).off('error', onError)
        resolve(end)
      }
      const onReport = (report: CommandReport) => {
        finish({ end: 'report', report })
        const keep = !report.isBug && report.memory < MOST_KEPT * this.#limits.memory
        if (keep && child.connected) this.#idle.push(child)
        else child.kill('SIGKILL')
      }
      const onEnd = (code: number | null, signal: NodeJS.Signals | null) => {
        if (late) finish({ end: 'time' })
        else if (lastWords.includes(OVER_MEMORY) || /heap (limit|out of memory)/i.test(lastWords)) {
          finish({ end: 'memory' })
        } else finish({ end: 'crash', reason: signal ?? `exit code ${code}` })
      }
      // The system may have no room for another process.
      const onError = ({ message }: Error) => finish({ end: 'crash', reason: message })
      child.stderr!.on('data', listen)
      child.once('message', onReport).once('close', onEnd).once('error', onError)
      // What cannot be sent has ended, and is told by `close`.
      child.send(request, () => {})
    })
  }

  /** Ends all processes, at once. */
  close(): void {
    for (const child of this.#all) child.kill('SIGKILL')
  }

  #start(): ChildProcess {
    const { memory } = this.#limits
    const child = fork(this.#program, [String(memory)], {
      execArgv: [`--max-old-space-size=${Math.ceil(memory / 2 ** 20)}`, NO_THREADS],
      stdio: ['ignore', 'ignore', 'pipe', 'ipc'],
      // Ctrl-C in a terminal reaches all processes of its group: jobs are ended by `close`, or finished first.
      detached: true,
    })
    this.#all.add(child)
    child.once('close', () => {
      this.#all.delete(child)
      const at = this.#idle.indexOf(child)
      if (at >= 0) this.#idle.splice(at, 1)
    })
    return child
  }
}
