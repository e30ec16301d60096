import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import { runWorker } from './run-worker.ts'

/**
 * Recognises the facial shapes of a skin's blendshapes in a web worker.
 *
 * @returns one entry per blendshape. Rejects with the signal's reason if aborted, and with a FurrowError if the worker fails.
 */
export function recogniseShapesInWorker(skin: Skin, signal: AbortSignal): Promise<RecognisedShape[]> {
  return runWorker({ type: 'shapes', skin }, { signal }, [], 'recogniseShapesInWorker')
}
