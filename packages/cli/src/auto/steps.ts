import { performance } from 'node:perf_hooks'
import type { Progress } from 'furrow-files'

/** Steps of a long task: reports progress and measures the time of each step. */
export class Steps {
  readonly #progress: Progress
  readonly #total: number
  readonly #started: { step: string; time: number }[] = []

  /** @param total number of steps. */
  constructor(progress: Progress, total: number) {
    this.#progress = progress
    this.#total = total
  }

  begin(step: string): void {
    this.#started.push({ step, time: performance.now() })
    this.#progress(this.#started.length - 1, this.#total, step)
  }

  /** Begins a step if it is not the current one, and reports its progress, 0..1. */
  at(step: string, done: number): void {
    if (this.#started.at(-1)?.step !== step) this.begin(step)
    this.#progress(this.#started.length - 1 + done, this.#total, step)
  }

  /** Reports that `done` of `parts` parts of the current step are done. */
  part(done: number, parts: number): void {
    const step = `${this.#started.at(-1)!.step} ${Math.min(done + 1, parts)}/${parts}`
    this.#progress(this.#started.length - 1 + done / parts, this.#total, step)
  }

  /** Returns the duration of each step in seconds; the last step ends now. */
  times(): { step: string; seconds: number }[] {
    const ends = [...this.#started.slice(1).map(({ time }) => time), performance.now()]
    return this.#started.map(({ step, time }, i) => ({ step, seconds: (ends[i] - time) / 1000 }))
  }
}
