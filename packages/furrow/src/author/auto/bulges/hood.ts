import { lerp } from '../../../math/scalar.ts'
import { bezierPath, chartPointOf, type FaceContext, type Side } from '../anatomy/region.ts'
import { type BulgeRegion, unevenness } from './bulge-region.ts'

/** Height of the hood's crest above the centre of the closed lids, in millimetres, at the middle of the eye. The crease of the lid is below it. */
const CREST = 5.5
/** Height of the crest above the outer corner of the eye, in millimetres. */
const OUTER_CREST = 4

/** Returns the hood of the upper lid: skin below the brow that sinks with age and overhangs the crease of the lid, most at the outer corner. */
export function hood({ landmarks, rngOf }: FaceContext, side: Side, name: string): BulgeRegion {
  const rng = rngOf(`hood${name}`)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const [outer, corner] = chartPointOf(landmarks.outerCorner)
  const eye = landmarks.eye[1]
  const at = (fraction: number) => lerp(inner, outer, fraction)
  const [drop, shift] = [rng.jitter(0.8), rng.jitter(0.05)]
  return {
    name: `hood${name}`,
    lines: [
      {
        path: bezierPath(
          side,
          [at(0.25 + shift), eye + CREST + 1.5],
          [at(0.55 + shift), eye + CREST + 1 - drop],
          [at(0.85), eye + CREST - drop],
          [at(1.2), corner + OUTER_CREST - 3 - drop],
        ),
        width: 12,
        height: 2.6 * unevenness(rng),
        heights: [0.5, 0.8, 1, 0.9, 0.5],
        // The hood slopes gently to the brow, and overhangs the crease.
        lean: -side * 0.1,
        taper: [0.4, 0.5],
      },
    ],
  }
}
