import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  type Side,
} from './region.ts'
import { relaxedPath } from './relaxed-path.ts'

/** Age fraction (see `FaceContext`) from which the marionette line exists. */
const MARIONETTE_AGE = 0.35
/** Fraction of length that the skin beside the corner loses. Blendshapes of many heads move the corner without compressing the skin beside it. */
const COMPRESSION = 0.2

/** Creates an arc beside the corner of the mouth. Older faces also get a marionette line below the corner (depressor anguli oris muscle). */
export function mouthCorner(
  { landmarks, ageFraction, byAge, rngOf, motionOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`mouthCorner${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  // The arc is smooth when the corner is pulled back.
  const moved = motionOf({ [`mouthDimple${name}`]: 0.9, [`mouthSmile${name}`]: 0.4 })
  const [pulled, height] = moved([side * corner, mouth])
  const beside = side * pulled + rng.uniform(5, 9)
  const high = byAge(0.8, 1.2) * rng.uniform(5, 10)
  const low = byAge(1, 0.6) * rng.uniform(5, 10)
  const tilt = rng.uniform(-1, 2.5)
  const bow = rng.uniform(2, 4)
  const arc = bezierPath(
    side,
    [beside - bow - tilt, height + high],
    [beside + 0.3 * bow - 0.4 * tilt, height + high / 2],
    [beside + 0.3 * bow + 0.4 * tilt, height - low / 2],
    [beside - bow + tilt, height - low],
  )
  const guides: Guide[] = [
    {
      path: relaxedPath(moved, arc),
      width: byAge(3.2, 3.8),
      depth: byAge(1, 0.3) * rng.uniform(0.7, 1),
      depths: [0.4, 0.8, 1, 0.8, 0.4],
      taper: [0.5, 0.5],
      // The bank is almost flat on the side of the lips.
      shoulder: side > 0 ? [0.9, 0.1] : [0.1, 0.9],
      softness: 0.9,
    },
  ]
  if (ageFraction > MARIONETTE_AGE) {
    const [across, up] = [corner + rng.uniform(1, 2.5), mouth - rng.uniform(1, 2.5)]
    const [curve, lean] = [rng.uniform(2, 4.5), rng.uniform(-1, 4)]
    const length = byAge(10, 27) * rng.uniform(0.8, 1.1)
    guides.push({
      path: bezierPath(
        side,
        [across, up],
        [across + curve, up - 0.3 * length],
        [across + curve + 0.6 * lean, up - 0.7 * length],
        [across + lean, up - length],
      ),
      width: byAge(3.4, 4.6),
      depth: byAge(0.4, 0.75) * rng.uniform(0.8, 1),
      depths: [0.55, 0.9, 1, 0.85, 0.6, 0.35],
      taper: [0.35, 0.6],
      shoulder: side > 0 ? [0.5, 0.2] : [0.2, 0.5],
      softness: 1,
    })
  }
  return {
    name: `mouthCorner${name}`,
    cause: { [`mouthDimple${name}`]: 1, [`mouthFrown${name}`]: 0.6, [`mouthSmile${name}`]: 0.2 },
    guides,
    spacing: 9,
    creasedFraction: byAge(0.4, 0.7),
    maxDepth: byAge(0.5, 1),
    atRest: 0.45,
    assumedCompression: COMPRESSION,
    reach: 4,
    feather: 5,
  }
}
