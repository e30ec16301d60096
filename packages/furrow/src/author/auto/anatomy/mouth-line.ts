import { lerp } from '../../../math/scalar.ts'
import { strongestBend } from './profile.ts'
import type { FaceContext } from './region.ts'

/** Heights above and below the corner of the mouth, in millimetres, between which the lips touch. */
const MOUTH_LINE = [8, -9] as const
/** Height where the chin protrudes most: 0 is the corner of the mouth, 1 the lower end of the chin. */
const CHIN_POINT = 0.75
/** Minimum distance in millimetres from the mouth line to the groove above the chin. */
const LIP = 4

/**
 * Returns the height at which the lips touch: the deepest point between them.
 *
 * @param across distance from the middle of the face on the head's chart, in millimetres, positive on the person's left.
 */
export function mouthLine({ landmarks, radiusAt }: FaceContext, across: number): number {
  const mouth = landmarks.mouthCorner[1]
  const [above, below] = MOUTH_LINE
  return strongestBend(radiusAt, [across, mouth + above], [across, mouth + below], -1)[1]
}

/** Returns the height of the groove between the lower lip and the chin (labiomental sulcus) in the middle of the face. */
export function chinGroove(context: FaceContext): number {
  const { landmarks, radiusAt } = context
  const chin = lerp(landmarks.mouthCorner[1], landmarks.chin, CHIN_POINT)
  return strongestBend(radiusAt, [0, mouthLine(context, 0) - LIP], [0, chin], -1)[1]
}
