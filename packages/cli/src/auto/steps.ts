import { performance } from 'node:perf_hooks'
import type { Progress } from '../progress.ts'

/** The steps of a long work, one after the other: shows them on a bar, and keeps how long each took. */
export class Steps {
  readonly #progress: Progress
  readonly #total: number
  readonly #begun: { step: string; at: number }[] = []

  /** @param total steps that there will be. */
  constructor(progress: Progress, total: number) {
    this.#progress = progress
    this.#total = total
  }

  begin(step: string): void {
    this.#begun.push({ step, at: performance.now() })
    this.#progress(this.#begun.length - 1, this.#total, step)
  }

  /** Of the step that was begun last. */
  part(done: number, parts: number): void {
    const step = `${this.#begun.at(-1)!.step} ${Math.min(done + 1, parts)}/${parts}`
    this.#progress(this.#begun.length - 1 + done / parts, this.#total, step)
  }

  /** Seconds of each step so far. */
  times(): { step: string; seconds: number }[] {
    const ends = [...this.#begun.slice(1).map(({ at }) => at), performance.now()]
    return this.#begun.map(({ step, at }, i) => ({ step, seconds: (ends[i] - at) / 1000 }))
  }
}
