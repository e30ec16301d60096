import { type ChildProcess, fork } from 'node:child_process'
import { once } from 'node:events'
import { cpSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import type { Outcome, Result, Task } from './child.ts'

/** Limits for one file of at most 10 MB. For larger files the limits grow in proportion to the size. */
export interface FileLimits {
  /** Processor time. */
  seconds: number
  /** Peak memory. */
  megabytes: number
}

/** Time limit for the answer of a process, wall-clock seconds. Long enough for a busy machine. */
const PATIENCE = 600

/** Result of a command on one damaged file. */
export interface Tried extends Result {
  index: number
}

export const FINE: readonly Outcome[] = ['success', 'refused', 'findings']

/**
 * Runs a command on damaged files in separate processes, and ends a process that exceeds its limits.
 *
 * @param child path of the bundled child.ts.
 * @param bases folder with the undamaged files.
 * @param keep folder that receives the files with unexpected outcomes.
 * @param stop ends the run early; the files in progress give no result.
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
      // Twice the time limit, so that a slow run still reports its time.
      const task = { command, seed, index, folder, seconds: 2 * limits.seconds }
      let result = await process.attempt(task, stop)
      // An earlier file may have caused the process's peak memory, so try again in a new process.
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

/** Sends tasks to a process. Starts another process when the last one has ended. */
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
      return failed('too slow', `no answer within ${PATIENCE} s`)
    } finally {
      clearTimeout(timer)
      done.abort()
    }
  }

  /** Starts a process without a terminal. So Ctrl-C reaches only the parent, and only the parent draws a progress bar. */
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
