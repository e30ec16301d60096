import { cos, sin } from '../../../math/elementary.ts'
import { length2 } from '../../../math/vector.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { FaceRng } from './face-rng.ts'
import { chinGroove } from './mouth-line.ts'
import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Guide } from './region.ts'

/** Number of dimples. */
const DIMPLES = 34
/** Angle in radians, around the centre of the dimpled oval, from each dimple to the next. */
const GOLDEN_ANGLE = 2.4
/** Oval that contains the dimples: distance of its centre from the groove above the chin, and half its height, in millimetres. */
const DIMPLED_BELOW = 13
const DIMPLED_RADIUS = 10

/** Returns the regions of the chin and the neck: chin dimples, the crease above the chin (mentalis muscle), and neck rings. */
export function chinAndNeck(context: FaceContext): FaceRegion[] {
  return [chin(context), neck(context)]
}

function chin(context: FaceContext): FaceRegion {
  const { landmarks, byAge, rngOf } = context
  const rng = rngOf('chin')
  const [corner] = chartPointOf(landmarks.mouthCorner)
  const groove = chinGroove(context)
  const half = corner * rng.uniform(0.45, 0.65)
  const [centre, tilt, arch] = [rng.across(1.5), rng.across(1), rng.uniform(2.5, 5)]
  const guides: Guide[] = [
    {
      path: bezierPath(
        1,
        [centre - half, groove - tilt - 0.6 * arch],
        [centre - half / 2, groove - tilt / 2 + 0.4 * arch],
        [centre + half / 2, groove + tilt / 2 + 0.4 * arch],
        [centre + half, groove + tilt - 0.6 * arch],
      ),
      width: byAge(5, 6),
      depth: 1,
      taper: [0.5, 0.5],
      shoulder: [0.6, 0.9],
      softness: 0.6,
    },
    ...dimples(rng, corner, [centre, groove - DIMPLED_BELOW]),
  ]
  return {
    name: 'chin',
    cause: { mouthShrugLower: 1, mouthFrownLeft: 0.3, mouthFrownRight: 0.3 },
    guides,
    spacing: 7,
    creasedFraction: byAge(0.3, 0.7),
    maxDepth: byAge(0.6, 1),
    atRest: 0.2,
    assumedCompression: 0.1,
    reach: 3,
    feather: 5,
  }
}

/** Position of a dimple in the oval that contains all dimples. The origin is the centre of the oval. */
interface Dimple {
  /** Millimetres, towards the person's left. */
  x: number
  /** Millimetres, upwards. */
  y: number
  /** Distance from the centre relative to the border of the oval, 0..1. */
  radius: number
}

/** @param corner distance of the corner of the mouth from the middle of the face, in millimetres. */
function dimples(rng: FaceRng, corner: number, [centre, middle]: ChartPoint): Guide[] {
  // The golden angle keeps dimples apart (H. Vogel 1979, A better way to construct the sunflower head).
  const dimpleAt = (i: number, turn: number): Dimple => {
    const angle = GOLDEN_ANGLE * i + turn
    const radius = Math.sqrt((i + 0.5) / DIMPLES)
    return { x: radius * 0.62 * corner * cos(angle), y: radius * DIMPLED_RADIUS * sin(angle), radius }
  }
  const mirrored = mirroredDimples(Array.from({ length: DIMPLES }, (_, i) => dimpleAt(i, 0)))
  const draw = (rng: FaceRng, i: number): Guide => {
    const turn = rng.across(0.3)
    const own = dimpleAt(i, turn)
    const partner = mirrored[i]
    const left = partner === undefined ? { ...own, x: -own.x } : dimpleAt(partner, -turn)
    const x = centre + rng.towards(-left.x, own.x)
    const y = middle + rng.towards(left.y, own.y)
    const radius = rng.towards(left.radius, own.radius)
    const direction = Math.PI / 2 + rng.across(Math.PI / 2)
    const halfLength = rng.uniform(0.8, 1.6)
    const [dx, dy] = [halfLength * cos(direction), halfLength * sin(direction)]
    return {
      path: bezierPath(
        1,
        [x - dx, y - dy],
        [x - dx / 3, y - dy / 3],
        [x + dx / 3, y + dy / 3],
        [x + dx, y + dy],
      ),
      width: rng.uniform(2.4, 3.4),
      depth: rng.uniform(0.35, 0.7) * (1.15 - radius),
      taper: [0.3, 0.3],
      shoulder: [0.9, 0.9],
      softness: 0.9,
      isDimple: true,
    }
  }
  return rng.row(DIMPLES, draw, (i) => mirrored[i])
}

/**
 * Pairs each dimple in the right half with the nearest free mirror image of a dimple in the left half.
 *
 * @returns for each dimple in the right half, the index of its partner; undefined for dimples in the left half.
 */
function mirroredDimples(places: readonly Dimple[]): (number | undefined)[] {
  const byX = [...places.keys()].sort((a, b) => places[a].x - places[b].x)
  const [right, left] = [byX.slice(0, places.length / 2), byX.slice(places.length / 2)]
  const partners: (number | undefined)[] = places.map(() => undefined)
  for (const i of right.reverse()) {
    const distance = (k: number) => length2(places[i].x + places[k].x, places[i].y - places[k].y)
    left.sort((a, b) => distance(b) - distance(a))
    partners[i] = left.pop()
  }
  return partners
}

function neck({ landmarks, byAge, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('neck')
  const rings = Math.round(byAge(2, 3))
  const guides = Array.from({ length: rings }, (_, i): Guide => {
    const up = landmarks.chin - 34 - 17 * i + rng.jitter(3)
    const left = 46 + rng.jitter(8)
    const right = rng.towards(left, 46 + rng.jitter(8))
    const [tilt, sag] = [rng.across(3), rng.uniform(5, 11)]
    const lift = rng.jitter(1)
    return {
      path: bezierPath(
        1,
        [-right, up - tilt + sag - 2],
        [-right / 3, up - tilt / 3 - 2 + rng.towards(lift, 0)],
        [left / 3, up + tilt / 3 - 2 + lift],
        [left, up + tilt + sag - 2],
      ),
      width: byAge(3, 4),
      depth: rng.uniform(0.7, 1),
      taper: [0.5, 0.5],
      shoulder: [0.3, 0.3],
      softness: 0.6,
    }
  })
  return {
    name: 'neck',
    cause: { jawOpen: 1 },
    guides,
    spacing: 17,
    creasedFraction: byAge(0.15, 0.5),
    maxDepth: byAge(0.3, 0.9),
    atRest: 0.5,
    reach: 6,
    feather: 8,
  }
}
