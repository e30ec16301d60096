import type { AutoWrinkles } from '../author/auto/auto.ts'
import type { Skin } from '../author/skin/surface.ts'
import { buffersOf } from './buffers.ts'
import type { AutoRunOptions } from './run-options.ts'
import { runWorker } from './run-worker.ts'

/** Settings of `autoWrinklesInWorker`. */
export interface AutoInWorkerOptions extends AutoRunOptions {
  /** Moves the skin's arrays to the worker without copying them: they and all views of their buffers are then empty. */
  transfer?: boolean
}

/**
 * Makes wrinkles from a character's own blendshapes as `autoWrinkles` does, bit for bit, in a web worker of its own. The page goes on
 * meanwhile. The result's arrays are moved here without copying them.
 *
 * A Content-Security-Policy must allow `worker-src blob:`, as it must for three.js's own decoders of KTX 2 and Draco.
 *
 * @returns a promise that rejects with a FurrowError where `autoWrinkles` throws it, where there are no workers, as in Node, and where the
 *   worker cannot start or dies; with the signal's reason when that is aborted.
 */
export async function autoWrinklesInWorker(
  skin: Skin,
  { transfer = false, ...options }: AutoInWorkerOptions = {},
): Promise<AutoWrinkles> {
  const buffers = transfer ? buffersOf(skin) : []
  return runWorker({ type: 'skin', skin }, options, buffers, 'autoWrinklesInWorker')
}
