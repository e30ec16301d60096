import { performance } from 'node:perf_hooks'
import type { Progress } from 'furrow-files'

/** The steps of a long task: reports them to a progress bar and measures how long each takes. */
export class Steps {
  readonly #progress: Progress
  readonly #total: number
  readonly #started: { step: string; time: number }[] = []

  /** @param total number of steps that will begin. */
  constructor(progress: Progress, total: number) {
    this.#progress = progress
    this.#total = total
  }

  begin(step: string): void {
    this.#started.push({ step, time: performance.now() })
    this.#progress(this.#started.length - 1, this.#total, step)
  }

  /** Begins a step unless it has begun, and reports how much of it is done, 0..1. */
  at(step: string, done: number): void {
    if (this.#started.at(-1)?.step !== step) this.begin(step)
    this.#progress(this.#started.length - 1 + done, this.#total, step)
  }

  /** Reports that `done` of the parts of the current step are done. */
  part(done: number, parts: number): void {
    const step = `${this.#started.at(-1)!.step} ${Math.min(done + 1, parts)}/${parts}`
    this.#progress(this.#started.length - 1 + done / parts, this.#total, step)
  }

  /** Seconds of each step; the last one ends now. */
  times(): { step: string; seconds: number }[] {
    const ends = [...this.#started.slice(1).map(({ time }) => time), performance.now()]
    return this.#started.map(({ step, time }, i) => ({ step, seconds: (ends[i] - time) / 1000 }))
  }
}
