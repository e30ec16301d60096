import { FurrowError } from 'furrow'
import { motionOf, type Take } from '../document/take.ts'
import type { Capture } from './live-link-face.ts'
import { columnsOf } from './take-columns.ts'

/**
 * Converts a facial capture to a take.
 *
 * @param targets names of the face's blendshapes.
 * @throws FurrowError if the face has none of the capture's blendshapes, or the capture is too long.
 */
export function takeOfCapture({ name, times, weights }: Capture, targets: readonly string[]): Take {
  if (columnsOf([...weights.keys()], targets).size === 0) throw missingBlendshapesError(name)
  return { name, motion: motionOf(times, weights) }
}

function missingBlendshapesError(name: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who: 'Studio',
    problem: `the face has none of the blendshapes in ${name}`,
    limit: 'names of ARKit, such as browInnerUp',
    remedy: 'name its blendshapes so, or open another avatar',
  })
}
