import { nextTask } from '../later.ts'

/** Number of steps between two checks for messages: a few milliseconds of work. */
const SLICE = 8

/** Runs optional work of a worker, a few steps at a time, so that the worker can answer calls in between. */
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
