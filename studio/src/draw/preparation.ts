import { nextTask } from '../later.ts'

/** Steps between checks for messages: 500 texels, a few milliseconds. */
const SLICE = 8

/** Speculative work in slices, so that the worker can answer calls in between. */
export class Preparation {
  #steps: Iterator<unknown> | null = null

  /** Runs steps and discards the remaining steps of the previous call. Null only discards. */
  async run(steps: Iterator<unknown> | null): Promise<void> {
    this.#steps = steps
    while (steps && steps === this.#steps) {
      for (let i = 0; i < SLICE; i++) if (steps.next().done) return
      await nextTask()
    }
  }
}
