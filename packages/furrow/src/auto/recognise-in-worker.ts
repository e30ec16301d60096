import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import { runWorker } from './run-worker.ts'

/**
 * `recogniseShapes` in a web worker of its own.
 *
 * @returns one entry per target; the promise rejects as that of `autoWrinklesInWorker` does.
 */
export function recogniseShapesInWorker(skin: Skin, signal: AbortSignal): Promise<RecognisedShape[]> {
  return runWorker({ type: 'shapes', skin }, { signal }, [], 'recogniseShapesInWorker')
}
