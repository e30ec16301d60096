import { bezierPath, chartPointOf, type FaceContext, type Side } from '../anatomy/region.ts'
import { wingGroove } from '../anatomy/wing-groove.ts'
import { type BulgeRegion, unevenness } from './bulge-region.ts'

/** Distance from the nasolabial fold to the crest of the cheek, in millimetres. */
const BESIDE_FOLD = 11

/** Returns the fullness of the cheek that sinks with age and hangs over the nasolabial fold. */
export function cheek(context: FaceContext, side: Side, name: string): BulgeRegion {
  const { landmarks, rngOf } = context
  const rng = rngOf(`cheek${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const base = landmarks.noseBase
  const top = wingGroove(context, side, base + 11) + BESIDE_FOLD
  const bottom = corner + 7 + BESIDE_FOLD
  const bow = rng.jitter(1.5)
  return {
    name: `cheek${name}`,
    lines: [
      {
        path: bezierPath(
          side,
          [top, base + 16],
          [top + 5 + bow, base + 4],
          [bottom - 1 + bow, mouth + 16],
          [bottom, mouth + 2],
        ),
        width: 26,
        height: 1.9 * unevenness(rng),
        // The side of the fold is steeper.
        lean: -side * 0.35,
        taper: [0.5, 0.5],
      },
    ],
  }
}
