import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { Skin } from '../author/skin/surface.ts'
import { buffersOf } from './buffers.ts'
import type { AutoRunOptions } from './run-options.ts'
import { runWorker } from './run-worker.ts'

/** Options of `autoWrinklesInWorker`. */
export interface AutoInWorkerOptions extends AutoRunOptions {
  /** Whether to transfer the arrays of the skin to the worker instead of copying them. Transferred arrays become empty on the page. */
  transfer?: boolean
}

/**
 * Makes wrinkles from the blendshapes and joints of a skin by running `autoWrinkles` in a web worker. The page stays responsive. The result
 * is the same as without a worker, and is transferred to the page without copying.
 *
 * If the page has a Content-Security-Policy, it must allow `worker-src blob:`. three.js's decoders of KTX 2 and Draco also need this.
 *
 * @returns a promise of the wrinkles. Rejects with the errors of `autoWrinkles`, or with the signal's reason if aborted. Rejects with a
 *   FurrowError if there are no web workers (as in Node), or if the worker cannot start or ends early.
 */
export async function autoWrinklesInWorker(
  skin: Skin,
  { transfer = false, ...options }: AutoInWorkerOptions = {},
): Promise<AutoWrinkles> {
  const buffers = transfer ? buffersOf(skin) : []
  return runWorker({ type: 'skin', skin }, options, buffers, 'autoWrinklesInWorker')
}
