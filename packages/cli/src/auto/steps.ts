import { performance } from 'node:perf_hooks'
import type { Progress } from 'furrow-files'

/** Reports the progress of a task that consists of steps, and measures the time of each step. */
export class Steps {
  readonly #progress: Progress
  readonly #total: number
  readonly #started: { step: string; time: number }[] = []

  constructor(progress: Progress, total: number) {
    this.#progress = progress
    this.#total = total
  }

  begin(step: string): void {
    this.#started.push({ step, time: performance.now() })
    this.#progress(this.#started.length - 1, this.#total, step)
  }

  /** Reports the progress of a step, 0..1. Begins the step if it is not the current one. */
  at(step: string, done: number): void {
    if (this.#started.at(-1)?.step !== step) this.begin(step)
    this.#progress(this.#started.length - 1 + done, this.#total, step)
  }

  /** Reports the progress inside the current step, which has `parts` parts. `done` is the number of ended parts. */
  part(done: number, parts: number): void {
    const step = `${this.#started.at(-1)!.step} ${Math.min(done + 1, parts)}/${parts}`
    this.#progress(this.#started.length - 1 + done / parts, this.#total, step)
  }

  /** Returns the duration of each step in seconds. The last step ends with this call. */
  times(): { step: string; seconds: number }[] {
    const ends = [...this.#started.slice(1).map(({ time }) => time), performance.now()]
    return this.#started.map(({ step, time }, i) => ({ step, seconds: (ends[i] - time) / 1000 }))
  }
}
