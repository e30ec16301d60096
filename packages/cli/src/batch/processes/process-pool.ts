import { type ChildProcess, fork } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { type CommandReport, type CommandRequest, OVER_MEMORY } from './protocol.ts'

const JOB_PROCESS = fileURLToPath(new URL('./job-process.js', import.meta.url))

export interface ProcessLimits {
  /** Resident memory of the process, bytes. */
  memory: number
  seconds: number
}

/** How a command ended: with a report, at a limit, or by a crash. */
export type ProcessEnd =
  | { end: 'report'; report: CommandReport }
  | { end: 'memory' | 'time' }
  | { end: 'crash'; reason: string }

/** A process that uses more than this fraction of the memory limit is not reused. */
const MAX_KEPT_MEMORY = 0.5

/**
 * V8 option that disables the threads of the compiler and the garbage collector. With one job per core, these threads
 * would compete with other jobs.
 */
const NO_THREADS = '--single-threaded'

/** Number of characters of stderr that are kept. */
const MAX_STDERR_LENGTH = 4096

/**
 * Runs commands in child processes. A process can be killed at a limit, and a crash affects only one job. Processes are
 * reused, because code that is already compiled makes later jobs faster.
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

  run(request: CommandRequest): Promise<ProcessEnd> {
    const child = this.#idle.pop() ?? this.#start()
    return new Promise((resolve) => {
      let stderr = ''
      let late = false
      const timer = setTimeout(() => {
        late = true
        child.kill('SIGKILL')
      }, this.#limits.seconds * 1000)
      const listen = (text: Buffer) => {
        stderr = `${stderr}${text}`.slice(-MAX_STDERR_LENGTH)
      }
      const finish = (end: ProcessEnd) => {
        clearTimeout(timer)
        child.stderr!.off('data', listen)
        child.off('message', onReport).off('close', onEnd).off('error', onError)
        resolve(end)
      }
      const onReport = (report: CommandReport) => {
        finish({ end: 'report', report })
        const keep = !report.isBug && report.memory < MAX_KEPT_MEMORY * this.#limits.memory
        if (keep && child.connected) this.#idle.push(child)
        else child.kill('SIGKILL')
      }
      const onEnd = (code: number | null, signal: NodeJS.Signals | null) => {
        if (late) finish({ end: 'time' })
        else if (stderr.includes(OVER_MEMORY) || /heap (limit|out of memory)/i.test(stderr)) {
          finish({ end: 'memory' })
        } else finish({ end: 'crash', reason: signal ?? `exit code ${code}` })
      }
      // The operating system could not start the process.
      const onError = ({ message }: Error) => finish({ end: 'crash', reason: message })
      child.stderr!.on('data', listen)
      child.once('message', onReport).once('close', onEnd).once('error', onError)
      // If sending fails, the process has ended, and `close` reports its end.
      child.send(request, () => {})
    })
  }

  close(): void {
    for (const child of this.#all) child.kill('SIGKILL')
  }

  #start(): ChildProcess {
    const { memory } = this.#limits
    const child = fork(this.#program, [String(memory)], {
      execArgv: [`--max-old-space-size=${Math.ceil(memory / 2 ** 20)}`, NO_THREADS],
      stdio: ['ignore', 'ignore', 'pipe', 'ipc'],
      // The process gets its own process group, so that Ctrl-C in the terminal does not reach running jobs.
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
