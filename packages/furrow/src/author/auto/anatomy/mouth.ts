import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  SIDES,
  type Side,
} from './region.ts'

/** Returns the regions around the mouth: nasolabial folds, lines beside the corners of the mouth, and vertical lines on the lips. */
export function mouth(context: FaceContext): FaceRegion[] {
  return [
    ...SIDES.flatMap(([side, name]) => [nasolabial(context, side, name), mouthCorner(context, side, name)]),
    lip(context, 'upperLip', 1),
    lip(context, 'lowerLip', -1),
  ]
}

/** Width in millimetres of the cheek skin whose compression forms the nasolabial fold. The skin of the lip hardly contributes. */
const CHEEK = 10

/** Creates the nasolabial fold: a deep line from the wing of the nose to a point beside the corner of the mouth, with a bulging cheek. */
function nasolabial(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`nasolabial${name}`)
  const [wing, base] = chartPointOf(landmarks.wing)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const beside = corner + 7.5 + rng.jitter(0.6)
  const end = mouth - byAge(2, 9)
  const path = bezierPath(
    side,
    [wing + 1, base + 14],
    [wing + 5.5, base + 3],
    [beside - 3, mouth + 11],
    [beside, end],
  )
  const guides: Guide[] = [
    {
      path,
      width: byAge(3.8, 4.6),
      depth: 1,
      taper: [0.2, 0.5],
      // The cheek hangs over the fold, so the bank on the cheek's side is higher.
      shoulder: side > 0 ? [1, 0.25] : [0.25, 1],
      lean: side * 0.25,
      gathers: side * CHEEK,
      softness: byAge(0.5, 0.3),
    },
  ]
  if (ageFraction > 0.4) {
    guides.push({
      path: path.slice(5, 15).map(([across, up], i) => [across + side * (3.5 + 0.5 * i), up + 0.5] as const),
      width: 1.8,
      depth: byAge(0.05, 0.22),
      taper: [0.5, 0.5],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    })
  }
  return {
    name: `nasolabial${name}`,
    cause: {
      [`mouthSmile${name}`]: 1,
      [`cheekSquint${name}`]: 0.2,
      [`noseSneer${name}`]: 0.3,
      [`mouthUpperUp${name}`]: 0.3,
    },
    guides,
    spacing: 14,
    creasedFraction: byAge(0.4, 0.8),
    maxDepth: byAge(1.2, 1.9),
    atRest: 0.55,
    reach: 6,
    feather: 6,
  }
}

/** Creates a short arc beside the corner of the mouth. Older faces also get a line from the corner downwards (depressor anguli oris). */
function mouthCorner(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`mouthCorner${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const arc = (out: number, high: number, low: number, width: number, depth: number): Guide => ({
    path: bezierPath(
      side,
      [corner + out - 1.5, mouth + high],
      [corner + out + 0.8, mouth + high / 2],
      [corner + out + 0.8, mouth - low / 2],
      [corner + out - 1, mouth - low],
    ),
    width,
    depth,
    taper: [0.5, 0.5],
    // The side of the lips has almost no bank.
    shoulder: side > 0 ? [0.8, 0.1] : [0.1, 0.8],
    softness: 0.5,
  })
  const guides = [arc(3.2 + rng.jitter(0.4), 5, 6, 2.6, 1)]
  if (ageFraction > 0.35) {
    guides.push({
      path: bezierPath(
        side,
        [corner + 1.5, mouth - 4],
        [corner + 3, mouth - 9],
        [corner + 4, mouth - 15],
        [corner + 5, mouth - byAge(16, 24)],
      ),
      width: 3.4,
      depth: byAge(0.5, 1),
      taper: [0.3, 0.6],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    })
  }
  return {
    name: `mouthCorner${name}`,
    cause: { [`mouthDimple${name}`]: 1, [`mouthFrown${name}`]: 0.6, [`mouthSmile${name}`]: 0.4 },
    guides,
    spacing: 6,
    creasedFraction: byAge(0.25, 0.7),
    maxDepth: byAge(0.5, 1),
    atRest: 0.45,
    reach: 3,
    feather: 4,
  }
}

/**
 * Creates fine lines that run away from the edge of a lip (orbicularis oris muscle).
 *
 * @param away 1 for lines that run upwards from the upper lip, -1 for lines that run downwards from the lower lip.
 */
function lip({ landmarks, byAge, rngOf }: FaceContext, name: string, away: 1 | -1): FaceRegion {
  const rng = rngOf(name)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const lines = Math.round(byAge(7, 11))
  const edge = corner * (away > 0 ? 0.28 : 0.44)
  const space = away > 0 ? landmarks.noseBase - mouth - edge : corner * 0.5
  const guides = Array.from({ length: lines }, (_, i): Guide => {
    const across = corner * 0.86 * ((2 * (i + rng.jitter(0.36))) / (lines - 1) - 1)
    const sink = edge * (1 - 0.55 * (across / corner) ** 2)
    const length = Math.max(4, space * rng.uniform(0.3, 0.9))
    const lean = 0.16 * across + rng.jitter(1.1)
    const from = mouth + away * sink
    return {
      path: bezierPath(
        1,
        [across, from],
        [across + 0.2 * lean, from + (away * length) / 3],
        [across + 0.6 * lean, from + (away * 2 * length) / 3],
        [across + lean, from + away * length],
      ),
      width: byAge(1.2, 1.5),
      depth: rng.uniform(0.55, 1),
      taper: [0.2, 0.7],
      shoulder: [0.8, 0.8],
      softness: 0.65,
    }
  })
  return {
    name,
    cause: { mouthPucker: 1, mouthFunnel: 0.3 },
    guides,
    spacing: (2 * corner * 0.86) / (lines - 1),
    creasedFraction: byAge(0.15, 0.7),
    maxDepth: byAge(0.25, 0.6),
    atRest: 0.4,
    reach: 1.5,
    feather: 4,
  }
}
