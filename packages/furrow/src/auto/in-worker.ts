import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { Skin } from '../author/skin/surface.ts'
import { buffersOf } from './buffers.ts'
import type { AutoRunOptions } from './run-options.ts'
import { runWorker } from './run-worker.ts'

/** Settings of `autoWrinklesInWorker`. */
export interface AutoInWorkerOptions extends AutoRunOptions {
  /** Transfers the skin's arrays to the worker instead of copying them; all views of their buffers become empty. */
  transfer?: boolean
}

/**
 * Makes wrinkles from a character's blendshapes as `autoWrinkles` does, bit for bit, in a separate web worker. The result is transferred
 * without copying.
 *
 * A Content-Security-Policy must allow `worker-src blob:`, as it must for three.js's decoders of KTX 2 and Draco.
 *
 * @returns a promise of the wrinkles. Rejects with the errors of `autoWrinkles`, or with the signal's reason if aborted. Rejects with a
 *   FurrowError if workers are missing (as in Node), or the worker cannot start or ends early.
 */
export async function autoWrinklesInWorker(
  skin: Skin,
  { transfer = false, ...options }: AutoInWorkerOptions = {},
): Promise<AutoWrinkles> {
  const buffers = transfer ? buffersOf(skin) : []
  return runWorker({ type: 'skin', skin }, options, buffers, 'autoWrinklesInWorker')
}
