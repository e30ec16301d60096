import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Side } from './region.ts'
import { wingGroove } from './wing-groove.ts'

/** Width in millimetres of the cheek skin whose compression forms the nasolabial fold. The skin of the lip hardly contributes. */
const CHEEK = 10
/** Fraction by which a smile is assumed to shorten the cheek across the fold. The blendshapes of many heads compress it less near the lips. */
const COMPRESSION = 0.3
/** Height of the fold's start above the base of the nose, in millimetres. */
const START = 11
/** Distance in millimetres at which the fold passes the corner of the mouth. */
const BESIDE_MOUTH = 7.3

/**
 * Creates the nasolabial fold: a deep line that starts in the groove beside the wing of the nose and passes the corner of the mouth. The cheek
 * bulges over it.
 */
export function nasolabial(context: FaceContext, side: Side, name: string): FaceRegion {
  const { landmarks, byAge, rngOf } = context
  const rng = rngOf(`nasolabial${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const start = landmarks.noseBase + START + rng.jitter(1.5)
  const groove = wingGroove(context, side, start)
  const beside = corner + BESIDE_MOUTH + rng.jitter(0.7)
  const end = mouth - byAge(2, 9) + rng.jitter(2.5)
  const bow = rng.jitter(2.5)
  return {
    name: `nasolabial${name}`,
    cause: {
      [`mouthSmile${name}`]: 1,
      [`cheekSquint${name}`]: 0.2,
      [`noseSneer${name}`]: 0.3,
      [`mouthUpperUp${name}`]: 0.3,
    },
    guides: [
      {
        path: bezierPath(
          side,
          [groove + 0.5, start],
          [groove + 5.5 + bow, start - 9],
          [beside - 2 + bow, mouth + 10 + rng.jitter(2)],
          [beside, end],
        ),
        width: byAge(3.8, 4.6),
        depth: 1,
        taper: [0.2, 0.5],
        // The cheek hangs over the fold, so the bank on the cheek's side is higher.
        shoulder: side > 0 ? [1, 0.25] : [0.25, 1],
        lean: side * 0.25,
        gathers: side * CHEEK,
        softness: byAge(0.5, 0.3),
      },
    ],
    spacing: 14,
    creasedFraction: byAge(0.4, 0.8),
    maxDepth: byAge(1.2, 1.9),
    atRest: 0.55,
    assumedCompression: COMPRESSION,
    reach: 6,
    feather: 6,
  }
}
