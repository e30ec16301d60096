import { lerp } from '../../../math/scalar.ts'
import { bezierPath, chartPointOf, type FaceContext, type Side } from '../anatomy/region.ts'
import { type BulgeRegion, unevenness } from './bulge-region.ts'

/** Range of distances below the centre of the closed lids in which the margin of the lower lid is searched, and the step, in millimetres. */
const SEARCHED = { from: 12, to: 5, step: 0.5 } as const
/** Distance of the margin below the centre of the closed lids, in millimetres, if the mesh has no hole at the eye. */
const USUAL_MARGIN = 8
/** Distances below the margin of the lower lid, in millimetres: crest of the bag, and groove below the bag. */
const CREST = 7.2
const GROOVE = 13

/**
 * Returns the bag under the eye: fat of the orbit that pushes the lower lid forward. Below it, skin is tied to the rim of the orbit and forms a
 * groove (tear trough and palpebromalar groove). Above it, the muscle along the lid's margin forms a narrow roll.
 */
export function bag(context: FaceContext, side: Side, name: string): BulgeRegion {
  const { landmarks, rngOf } = context
  const rng = rngOf(`bag${name}`)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const [outer] = chartPointOf(landmarks.outerCorner)
  const at = (fraction: number) => lerp(inner, outer, fraction)
  const margin = lidMargin(context, side * at(0.5))
  const size = unevenness(rng)
  const [sag, slant, shift] = [rng.jitter(1), rng.jitter(1), rng.jitter(0.04)]
  const crest = margin - CREST - sag
  const groove = margin - GROOVE - sag
  return {
    name: `bag${name}`,
    lines: [
      {
        path: bezierPath(
          side,
          [at(0.1), margin - 4.5],
          [at(0.33 + shift), crest - 1.2 - slant],
          [at(0.7 + shift), crest - 1 + slant],
          [at(1), margin - 4],
        ),
        width: 12,
        height: 1.8 * size,
        taper: [0.4, 0.4],
      },
      {
        path: bezierPath(
          side,
          [at(0.02), margin - 3],
          [at(0.3 + shift), groove - 2 - slant],
          [at(0.65 + shift), groove - 1 + slant],
          [at(1.02), margin - 6],
        ),
        width: 5.5,
        height: -0.5 * size,
        heights: [1, 1, 0.85, 0.6, 0.4],
        taper: [0.3, 0.5],
      },
      {
        path: bezierPath(
          side,
          [at(0.15), margin - 2.5],
          [at(0.4), margin - 4],
          [at(0.7), margin - 4],
          [at(0.95), margin - 1.5],
        ),
        width: 4,
        height: 0.4,
        taper: [0.4, 0.4],
      },
    ],
  }
}

/** Returns the chart's `up` coordinate of the margin of the lower lid, which is the lower edge of the hole at the eye. */
function lidMargin({ landmarks, radiusAt }: FaceContext, across: number): number {
  const eye = landmarks.eye[1]
  for (let below: number = SEARCHED.from; below >= SEARCHED.to; below -= SEARCHED.step)
    if (radiusAt([across, eye - below]) === undefined) return eye - below
  return eye - USUAL_MARGIN
}
