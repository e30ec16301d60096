import { nextTask } from '../../runtime/next-task.ts'

/** Duration of a time slice, milliseconds: half of a frame at 60 frames per second. */
const SLICE = 8

/**
 * Runs a generator in time slices, so that the page stays responsive.
 *
 * @param isWanted called after each pause; if it returns false, the generator is not continued.
 * @returns the result of the generator; null if it was not continued.
 */
export async function inSlices<T>(steps: Generator<void, T>, isWanted: () => boolean): Promise<T | null> {
  let started = performance.now()
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
    if (performance.now() - started < SLICE) continue
    await nextTask()
    if (!isWanted()) return null
    started = performance.now()
  }
}
