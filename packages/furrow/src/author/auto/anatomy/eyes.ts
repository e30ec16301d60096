import { crowsFeet } from './crows-feet.ts'
import { lowerLid } from './lower-lid.ts'
import { type FaceContext, type FaceRegion, SIDES } from './region.ts'

/** Returns the regions around the eyes: crow's feet, and the skin below the lower lids. */
export function eyes(context: FaceContext): FaceRegion[] {
  return SIDES.flatMap(([side, name]) => [crowsFeet(context, side, name), lowerLid(context, side, name)])
}
