import { type ChildProcess, fork } from 'node:child_process'
import { once } from 'node:events'
import { cpSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import type { Outcome, Result, Task } from './child.ts'

/** Limits for a file of up to 10 MB. They grow in proportion for larger files. */
export interface FileLimits {
  /** Processor time. */
  seconds: number
  /** Peak memory. */
  megabytes: number
}

/** Time limit for a process that stopped answering, wall-clock seconds. Long enough for a busy machine. */
const PATIENCE = 600

/** Result of one file. */
export interface Tried extends Result {
  index: number
}

export const FINE: readonly Outcome[] = ['success', 'refused', 'findings']

/**
 * Tries files in separate processes, and ends a process that exceeds its limits.
 *
 * @param child the bundled child.ts.
 * @param bases folder with the undamaged files.
 * @param keep folder for files that fail.
 * @param stop ends the run early, without the file in progress.
 */
export async function tryFiles(
  { child, bases, work, keep }: { child: string; bases: string; work: string; keep: string },
  { command, seed, first, count }: { command: string; seed: number; first: number; count: number },
  limits: FileLimits,
  jobs: number,
  report: (tried: Tried) => void,
  stop: AbortSignal,
): Promise<Tried[]> {
  const all: Tried[] = []
  let next = first
  const worker = async (job: number) => {
    const process = new Attempts(child, bases, limits)
    const folder = join(work, `job-${job}`)
    while (next < first + count && !stop.aborted) {
      const index = next++
      // Twice the limit, to tell slow files from hanging ones.
      const task = { command, seed, index, folder, seconds: 2 * limits.seconds }
      let result = await process.attempt(task, stop)
      // An earlier file may have caused the peak, so a new process decides.
      if (result.outcome === 'too large') result = await process.attempt(task, stop)
      if (stop.aborted) break
      const tried = { ...result, index }
      if (!FINE.includes(tried.outcome)) {
        cpSync(folder, join(keep, `${command.replaceAll(/\W+/g, '-')}-${seed}-${index}`), { recursive: true })
      }
      all.push(tried)
      report(tried)
    }
    process.end()
    rmSync(folder, { recursive: true, force: true })
  }
  await Promise.all(Array.from({ length: jobs }, (_, job) => worker(job)))
  return all
}

/** Runs one process at a time, and restarts it after it was ended. */
class Attempts {
  readonly #path: string
  readonly #bases: string
  readonly #limits: FileLimits
  #process: ChildProcess | undefined

  constructor(path: string, bases: string, limits: FileLimits) {
    this.#path = path
    this.#bases = bases
    this.#limits = limits
  }

  async attempt(task: Task, stopAll: AbortSignal): Promise<Result> {
    this.#process ??= this.#start()
    const child = this.#process
    const { seconds, megabytes } = this.#limits
    const done = new AbortController()
    const signal = AbortSignal.any([done.signal, stopAll])
    const failed = (outcome: Outcome, message: string): Result => {
      this.end()
      return { outcome, message, milliseconds: 1000 * seconds, bytes: 0, peak: 0 }
    }
    const timer = setTimeout(() => done.abort(), 1000 * PATIENCE)
    child.send(task)
    try {
      const result = await Promise.race([
        once(child, 'message', { signal }).then(([message]) => message as Result),
        once(child, 'exit', { signal }).then(([code, ended]) => {
          return ended === 'SIGKILL'
            ? failed('too slow', `more than ${2 * seconds} s`)
            : failed('died', `the process ended with ${ended ?? code}`)
        }),
      ])
      const factor = Math.max(1, result.bytes / 1e7)
      if (result.peak > 2 ** 20 * megabytes * factor) {
        this.end()
        return { ...result, outcome: 'too large', message: `${Math.round(result.peak / 2 ** 20)} MB` }
      }
      const message = `${(result.milliseconds / 1000).toFixed(1)} s`
      return result.milliseconds > 1000 * seconds * factor
        ? { ...result, outcome: 'too slow', message }
        : result
    } catch {
      return failed('too slow', `nothing for ${PATIENCE} s`)
    } finally {
      clearTimeout(timer)
      done.abort()
    }
  }

  /** Detached from the terminal: Ctrl-C is for the parent, and progress bars would hide the parent's. */
  #start(): ChildProcess {
    const stdio = ['ignore', 'inherit', 'pipe', 'ipc'] as const
    const child = fork(this.#path, [this.#bases], { stdio: [...stdio], detached: true })
    child.stderr!.pipe(process.stderr, { end: false })
    return child
  }

  end(): void {
    this.#process?.kill('SIGKILL')
    this.#process = undefined
  }
}
