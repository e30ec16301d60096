import { chin } from './chin.ts'
import { eyes } from './eyes.ts'
import { forehead } from './forehead.ts'
import { frown } from './frown.ts'
import { lips } from './lips.ts'
import { mouthCorner } from './mouth-corner.ts'
import { nasolabial } from './nasolabial.ts'
import { neck } from './neck.ts'
import { nose } from './nose.ts'
import { type FaceContext, type FaceRegion, SIDES } from './region.ts'
import type { AutoRegion } from './region-names.ts'

/** Returns the requested regions of a face, for both sides. */
export function faceRegions(context: FaceContext, wanted: readonly AutoRegion[]): FaceRegion[] {
  const names = new Set<string>(wanted)
  return [forehead, frown, nose, eyes, besideMouth, lips, chin, neck]
    .flatMap((part) => part(context))
    .filter(({ name }) => names.has(name.replace(/(Left|Right)$/, '')))
}

function besideMouth(context: FaceContext): FaceRegion[] {
  return SIDES.flatMap(([side, name]) => [nasolabial(context, side, name), mouthCorner(context, side, name)])
}
