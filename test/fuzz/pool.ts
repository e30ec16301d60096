import { type ChildProcess, fork } from 'node:child_process'
import { once } from 'node:events'
import { cpSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import type { Outcome, Result, Task } from './child.ts'

/** What one file of up to 10 MB may cost; a larger one as many times as much as it is larger. */
export interface FileLimits {
  /** Of the processor. */
  seconds: number
  /** Of memory. */
  megabytes: number
}

/** Seconds of the clock after which a process waits for what will not come, however busy the machine is. */
const PATIENCE = 600

/** A file that was tried. */
export interface Tried extends Result {
  index: number
}

export const FINE: readonly Outcome[] = ['success', 'refused', 'findings']

/**
 * Tries files in processes of their own, which are ended where a file takes too long.
 *
 * @param child the bundled child.ts.
 * @param bases folder with the undamaged files.
 * @param keep folder for the files that fail.
 * @param stop ends it early, without the file that is being tried.
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
      // Twice its time, so that what is only too slow is told from what hangs.
      const task = { command, seed, index, folder, seconds: 2 * limits.seconds }
      let result = await process.attempt(task, stop)
      // The peak may be that of an earlier file: the verdict is that of a new process.
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

/** One process at a time; a new one where the last was ended. */
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

  /** Without the terminal: its Ctrl-C is for the parent, and the commands' bars would hide the parent's. */
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
