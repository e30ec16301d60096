import { lerp } from '../../../math/scalar.ts'
import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  fade,
  type Guide,
  SIDES,
  type Side,
} from './region.ts'

/** Fraction of length that the skin between the brows loses. Blendshapes of many heads lower the brows without moving them together. */
const COMPRESSION = 0.12
/** Half the width, in millimetres, of the transition between the left and the right area. */
const MIDDLE = 2

/**
 * Returns the regions that crease in a frown. They have vertical lines between the brows (corrugator muscle) and horizontal lines on the root
 * of the nose (procerus muscle). The number of lines grows with age.
 */
export function frown(context: FaceContext): FaceRegion[] {
  return [...SIDES.map(([side, name]) => glabella(context, side, name)), noseRoot(context)]
}

function glabella(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`glabella${name}`)
  const [inner, brow] = chartPointOf(landmarks.innerBrow)
  /** Returns a line from the head of the brow upwards. It leans outwards and bends towards the nose at the bottom. */
  const line = (
    across: number,
    [low, high]: readonly [number, number],
    lean: number,
    width: number,
    depth: number,
  ): Guide => ({
    path: bezierPath(
      side,
      [across - rng.uniform(0.5, 1.5), brow + low],
      [across + 0.3, brow + lerp(low, high, 0.35)],
      [across + 0.2 * lean, brow + lerp(low, high, 0.65)],
      [across + lean, brow + high],
    ),
    width,
    depth,
    taper: [0.5, 0.5],
    shoulder: [1, 1],
    softness: byAge(0.9, 0.8),
  })
  // Many people frown more on one side, and the lines of both sides are more or less parallel.
  const both = rngOf('glabellaLeft')
  const [leaning, onRight] = [both.uniform(0.5, 6), both.jitter(1)]
  const [weakerLeft, weakerRight] = [Math.max(0, onRight), Math.max(0, -onRight)]
  const weaker = side > 0 ? weakerLeft : rng.towards(weakerLeft, weakerRight)
  const main = inner * rng.uniform(0.42, 0.6)
  const extent = [rng.uniform(-12, -8), rng.uniform(11, 18) - 5 * weaker] as const
  const guides = [line(main, extent, leaning + rng.jitter(1), byAge(3.7, 4.1), 1 - 0.15 * weaker)]
  // The corrugator folds the skin outside its main line again. Few people have a line between the two main lines.
  const beside = main + rng.uniform(4, 5.5)
  if (ageFraction > rng.uniform(0.1, 0.5))
    guides.push(
      line(
        beside,
        [-6, rng.uniform(7, 14)],
        leaning + rng.uniform(-0.5, 1.5),
        3.6,
        byAge(0.35, 0.6) * rng.uniform(0.7, 1),
      ),
    )
  if (ageFraction > rng.uniform(0.4, 1.2))
    guides.push(
      line(main - 3.8, [-5, rng.uniform(6, 12)], leaning + rng.uniform(-1.5, 0.5), 3, rng.uniform(0.25, 0.4)),
    )
  return {
    name: `glabella${name}`,
    cause: { [`browDown${name}`]: 1, [`browDown${side > 0 ? 'Right' : 'Left'}`]: 0.5 },
    guides,
    spacing: 11,
    creasedFraction: byAge(0.6, 1),
    maxDepth: byAge(1.22, 1.65),
    atRest: 0.36,
    assumedCompression: COMPRESSION,
    reach: 5,
    feather: 6,
    influence: ([across]) => fade(side * across, -MIDDLE, MIDDLE),
  }
}

function noseRoot({ landmarks, ageFraction, byAge, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('noseRoot')
  const middle = landmarks.eye[1] + 2 + rng.jitter(2)
  const tilt = rng.across(2.2)
  const line = (up: number, half: number, width: number, depth: number): Guide => {
    const [centre, arch] = [rng.across(2.2), rng.uniform(-0.6, 2.2)]
    return {
      path: bezierPath(
        1,
        [centre - half, up - tilt - arch / 2],
        [centre - half / 3, up - tilt / 3 + arch / 2],
        [centre + half / 3, up + tilt / 3 + arch / 2],
        [centre + half, up + tilt - arch / 2],
      ),
      width,
      depth,
      taper: [0.45, 0.45],
      shoulder: [0.9, 0.9],
      softness: 0.8,
    }
  }
  const guides = [line(middle, rng.uniform(7, 10), byAge(2.5, 3), 1)]
  if (ageFraction > rng.uniform(0.15, 0.55))
    guides.push(line(middle - rng.uniform(4, 5.5), rng.uniform(5, 8), 2.4, rng.uniform(0.4, 0.7)))
  if (ageFraction > rng.uniform(0.5, 1.1))
    guides.push(line(middle + rng.uniform(4, 5.5), rng.uniform(4, 6), 2.2, rng.uniform(0.25, 0.45)))
  return {
    name: 'noseRoot',
    cause: { browDownLeft: 1, browDownRight: 1, noseSneerLeft: 0.5, noseSneerRight: 0.5 },
    guides,
    spacing: 9,
    creasedFraction: byAge(0.3, 0.8),
    maxDepth: byAge(0.6, 1.1),
    atRest: 0.3,
    reach: 4,
    feather: 5,
  }
}
