import { nextTask } from '../later.ts'

/** Steps of a preparation between which a worker answers calls: 500 texels, which take a few milliseconds. */
const SLICE = 8

/** Work that may be needed soon, done in slices: whatever is asked of the worker comes between them. */
export class Preparation {
  #steps: Iterator<unknown> | null = null

  /** Does some steps, instead of those that are left of the last call; null for none. */
  async run(steps: Iterator<unknown> | null): Promise<void> {
    this.#steps = steps
    while (steps && steps === this.#steps) {
      for (let i = 0; i < SLICE; i++) if (steps.next().done) return
      await nextTask()
    }
  }
}
