import { atan2, cos, sin } from '../../../math/elementary.ts'
import { length2 } from '../../../math/vector.ts'
import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Side } from './region.ts'
import { relaxedPath } from './relaxed-path.ts'
import { intoCrease } from './sculpted-crease.ts'
import { wingGroove } from './wing-groove.ts'

/** Fraction by which a smile is assumed to shorten the cheek across the fold. The blendshapes of many heads compress it less near the lips. */
const COMPRESSION = 0.3
/** Height of the fold's start above the base of the nose, in millimetres. */
const START = 9
/** Distance in millimetres at which the fold passes the corner of the smiling mouth. */
const BESIDE_MOUTH = 12
/** Length of the handles of the curve, as a fraction of the distance between its ends. */
const HANDLE = 0.36
/** Depths along the fold. The upper half is deepest. */
const DEPTHS = [0.8, 1, 1, 0.95, 0.85, 0.75, 0.6]
/**
 * Angles between the fold and the straight line between its ends, at its start and end, in radians. A full smile bends the lower half more than
 * the upper half, so the drawn curve bends more at its start.
 */
const BENDS = [0.5, 0.45] as const

/**
 * Creates the nasolabial fold: a deep line that starts in the groove beside the wing of the nose and passes the corner of the mouth. The cheek
 * bulges over it. The curve is drawn on the face with 70% of a smile, in which real folds are smooth, and then moved to the resting face. Drawn on
 * a sneering or fully smiling face, the curve would have a hook.
 */
export function nasolabial(context: FaceContext, side: Side, name: string): FaceRegion {
  const { landmarks, byAge, rngOf, motionOf, posedBy } = context
  const rng = rngOf(`nasolabial${name}`)
  const smile = { [`mouthSmile${name}`]: 0.7, [`cheekSquint${name}`]: 0.35 }
  const moved = motionOf(smile)
  const smiling = (across: number, up: number) => {
    const [x, y] = moved([side * across, up])
    return [side * x, y] as const
  }
  const height = landmarks.noseBase + START + rng.jitter(1.5)
  const start = smiling(wingGroove(context, side, height), height)
  const corner = smiling(...chartPointOf(landmarks.mouthCorner))
  const end = [corner[0] + BESIDE_MOUTH + rng.jitter(1), corner[1] - byAge(9, 12) + rng.jitter(2.5)] as const
  const [dx, dy] = [end[0] - start[0], end[1] - start[1]]
  const handle = HANDLE * length2(dx, dy)
  const straight = atan2(dy, dx)
  const leaving = straight + BENDS[0] + rng.jitter(0.15)
  const arriving = straight - BENDS[1] + rng.jitter(0.15)
  const path = bezierPath(
    side,
    start,
    [start[0] + handle * cos(leaving), start[1] + handle * sin(leaving)],
    [end[0] - handle * cos(arriving), end[1] - handle * sin(arriving)],
    end,
  )
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
        path: intoCrease(posedBy(smile), relaxedPath(moved, path)),
        width: byAge(3.8, 4.6),
        depth: 1,
        depths: DEPTHS,
        taper: [0.08, 0.45],
        // The cheek hangs over the fold, so the bank on the cheek's side is higher.
        shoulder: side > 0 ? [1, 0.15] : [0.15, 1],
        lean: side * 0.35,
        softness: byAge(0.75, 0.55),
      },
    ],
    spacing: 15,
    creasedFraction: byAge(0.4, 0.8),
    maxDepth: byAge(0.9, 1.8),
    atRest: 0.59,
    assumedCompression: COMPRESSION,
    reach: 7,
    feather: 7,
  }
}
