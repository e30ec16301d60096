import { nextTask } from '../../runtime/next-task.ts'

/** Milliseconds of work between pauses: half of a frame. */
const SLICE = 8

/**
 * Runs a generator to its end, with pauses in which the page draws and answers.
 *
 * @param isWanted asked after each pause.
 * @returns what the generator returns; null if that is no longer wanted.
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
