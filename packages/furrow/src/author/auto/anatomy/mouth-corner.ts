import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  type Side,
} from './region.ts'

/** Age fractions (see `FaceContext`) from which the marionette line and the outer arc exist. */
const MARIONETTE_AGE = 0.35
const OUTER_AGE = 0.5

/** Creates an arc beside the corner of the mouth. Older faces also get a marionette line below the corner (depressor anguli oris muscle). */
export function mouthCorner(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`mouthCorner${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  /** Returns a line that curves around the corner, from `high` above it to `low` below it. */
  const arc = (out: number, high: number, low: number, width: number, depth: number): Guide => {
    const [atTop, atBottom] = [rng.jitter(1), rng.jitter(1)]
    return {
      path: bezierPath(
        side,
        [corner + out - 1.8 + atTop, mouth + high],
        [corner + out + 0.9, mouth + high / 2],
        [corner + out + 0.9, mouth - low / 2],
        [corner + out - 1.4 + atBottom, mouth - low],
      ),
      width,
      depth,
      taper: [0.5, 0.5],
      // The bank is almost flat on the side of the lips.
      shoulder: side > 0 ? [0.8, 0.1] : [0.1, 0.8],
      softness: 0.5,
    }
  }
  const guides = [arc(rng.uniform(1.6, 4), rng.uniform(2, 6), rng.uniform(3, 7), 2.6, rng.uniform(0.75, 1))]
  if (ageFraction > MARIONETTE_AGE) {
    const out = rng.uniform(0.5, 3)
    const length = byAge(10, 20) * rng.uniform(0.75, 1.1)
    const [curve, lean] = [rng.uniform(1, 3), rng.uniform(0.5, 4)]
    guides.push({
      path: bezierPath(
        side,
        [corner + out, mouth - 4],
        [corner + out + curve, mouth - 4 - 0.35 * length],
        [corner + out + curve + 0.5 * lean, mouth - 4 - 0.7 * length],
        [corner + out + lean, mouth - 4 - length],
      ),
      width: 3.2,
      depth: byAge(0.5, 1) * rng.uniform(0.8, 1),
      taper: [0.45, 0.6],
      shoulder: [0.8, 0.8],
      softness: 0.5,
    })
  }
  if (ageFraction > OUTER_AGE)
    guides.push(arc(rng.uniform(6.5, 8.5), rng.uniform(1, 4), rng.uniform(4, 9), 2.2, rng.uniform(0.2, 0.45)))
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
