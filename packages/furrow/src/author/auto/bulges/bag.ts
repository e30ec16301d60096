import { lerp } from '../../../math/scalar.ts'
import { bezierPath, chartPointOf, type FaceContext, type Side } from '../anatomy/region.ts'
import { type BulgeRegion, unevenness } from './bulge-region.ts'

/** Distances below the margin of the lower lid, in millimetres: crest of the bag, and groove below the bag. */
const CREST = 7.2
const GROOVE = 13

/**
 * Returns the bag under the eye: fat of the orbit that pushes the lower lid forward. Below it, skin is tied to the rim of the orbit and forms a
 * groove (tear trough and palpebromalar groove). Above it, the muscle along the lid's margin forms a narrow roll.
 */
export function bag({ landmarks, openingOf, rngOf }: FaceContext, side: Side, name: string): BulgeRegion {
  const rng = rngOf(`bag${name}`)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const [outer] = chartPointOf(landmarks.outerCorner)
  const at = (fraction: number) => lerp(inner, outer, fraction)
  const margin = openingOf(side).lowest
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
        width: 12.5,
        height: 2.3 * size,
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
        height: -0.8 * size,
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
