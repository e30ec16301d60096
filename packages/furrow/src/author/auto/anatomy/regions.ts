import { chinAndNeck } from './chin.ts'
import { eyes } from './eyes.ts'
import { forehead } from './forehead.ts'
import { frown } from './frown.ts'
import { mouth } from './mouth.ts'
import { nose } from './nose.ts'
import type { FaceContext, FaceRegion } from './region.ts'
import type { AutoRegion } from './region-names.ts'

/** Returns the requested regions of a face, for both sides. */
export function faceRegions(context: FaceContext, wanted: readonly AutoRegion[]): FaceRegion[] {
  const names = new Set<string>(wanted)
  return [forehead, frown, nose, eyes, mouth, chinAndNeck]
    .flatMap((part) => part(context))
    .filter(({ name }) => names.has(name.replace(/(Left|Right)$/, '')))
}
