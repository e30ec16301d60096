import { nextTask } from '../../runtime/next-task.ts'

/** Length of a time slice, milliseconds: half a frame. */
const SLICE = 8

/**
 * Runs a generator in time slices, so that the page stays responsive.
 *
 * @param isWanted polled after each pause.
 * @returns the generator's result; null if stopped because `isWanted` returned false.
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
