import type { RecognisedShape } from '../author/shapes/recognise.ts'
import type { Skin } from '../author/skin/surface.ts'
import { runWorker } from './run-worker.ts'

/**
 * Runs `recogniseShapes` in a separate web worker.
 *
 * @returns one entry per target; rejects as `autoWrinklesInWorker` does.
 */
export function recogniseShapesInWorker(skin: Skin, signal: AbortSignal): Promise<RecognisedShape[]> {
  return runWorker({ type: 'shapes', skin }, { signal }, [], 'recogniseShapesInWorker')
}
