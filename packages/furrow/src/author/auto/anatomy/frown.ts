import { smoothstep } from '../../../math/scalar.ts'
import {
  bezierPath,
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  type Guide,
  SIDES,
  type Side,
} from './region.ts'

/** Half the width, in millimetres, of the transition between the left and the right area. */
const MIDDLE = 2

/**
 * Returns the regions of frowning: vertical lines between the brows, whose number grows with age (corrugator muscle), and horizontal lines on
 * the root of the nose (procerus muscle).
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
  const centre = 0.5 * inner + rng.jitter(0.5)
  const line = (across: number, low: number, high: number, width: number, depth: number): Guide => ({
    // The line leans outwards at the top and bends towards the nose at the bottom.
    path: bezierPath(
      side,
      [across - 0.6, brow + low],
      [across + 0.3, brow + low + 6],
      [across, brow + high - 8],
      [across + 1.6, brow + high],
    ),
    width,
    depth,
    taper: [0.4, 0.5],
    shoulder: [0.9, 0.9],
    softness: byAge(0.6, 0.5),
  })
  const guides = [line(centre, -8 + rng.jitter(1), 15 + rng.jitter(2), byAge(2.8, 3.6), 1)]
  if (ageFraction > 0.2)
    guides.push(line(centre + 4.6 + rng.jitter(0.5), -2, 11 + rng.jitter(2), 2.6, byAge(0.35, 0.6)))
  if (ageFraction > 0.5) guides.push(line(centre - 3.6, -1, 9 + rng.jitter(2), 2.2, 0.35))
  return {
    name: `glabella${name}`,
    cause: { [`browDown${name}`]: 1, [`browDown${side > 0 ? 'Right' : 'Left'}`]: 0.5 },
    guides,
    spacing: 11,
    creasedFraction: byAge(0.6, 1),
    maxDepth: byAge(1.1, 2.1),
    atRest: 0.35,
    reach: 5,
    feather: 6,
    influence: ([across]) => smoothstep((side * across + MIDDLE) / (2 * MIDDLE)),
  }
}

function noseRoot({ landmarks, ageFraction, byAge, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('noseRoot')
  const level = landmarks.eye[1] + 2
  const line = (up: number, half: number, width: number, depth: number): Guide => ({
    path: bezierPath(1, [-half, up - 1.2], [-half / 3, up + 0.8], [half / 3, up + 0.8], [half, up - 1.2]),
    width,
    depth,
    taper: [0.45, 0.45],
    shoulder: [0.9, 0.9],
    softness: 0.65,
  })
  const guides = [line(level + rng.jitter(0.6), 9, byAge(2.5, 3), 1)]
  if (ageFraction > 0.35) guides.push(line(level - 4.6, 6.5, 2.4, 0.5))
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
