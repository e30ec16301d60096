import { cos, sin } from '../../../math/elementary.ts'
import { length2 } from '../../../math/vector.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { FaceRng } from './face-rng.ts'
import { chinGroove } from './mouth-line.ts'
import { strongestBend } from './profile.ts'
import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Guide } from './region.ts'

/** Number of dimples. */
const DIMPLES = 46
/** Angle in radians, around the centre of the dimpled oval, from each dimple to the next. */
const GOLDEN_ANGLE = 2.4
/** Maximum random distances from a dimple's regular place: along the circle, in radians, and from the centre, relative to the oval. */
const SCATTER = [0.4, 0.07] as const
/** Depth of a dimple (see `LineStyle.depth`) per millimetre of its width. */
const STEEPNESS = 0.12
/** Half the width of the dimpled mound of the chin, relative to the distance of the corner of the mouth from the middle. */
const MOUND_WIDTH = 0.9
/** Distances, in millimetres, of the mound from the groove above the chin and from the edge below the chin. */
const BELOW_GROOVE = 3
const ABOVE_EDGE = 2
/** Distance below the end of the chin, in millimetres, down to which the chin's lower edge is searched. */
const SEARCHED = 14

/** Returns the region of the chin: dimples, and the crease above the chin (mentalis muscle). */
export function chin(context: FaceContext): FaceRegion {
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
    ...dimples(context, rng, moundOf(context, groove, centre)),
  ]
  return {
    name: 'chin',
    cause: { mouthShrugLower: 1, mouthFrownLeft: 0.3, mouthFrownRight: 0.3 },
    guides,
    spacing: 7,
    creasedFraction: byAge(0.3, 0.7),
    maxDepth: byAge(0.4, 1),
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

/** Oval that contains the dimples. */
interface Mound {
  centre: ChartPoint
  halfWidth: number
  halfHeight: number
}

/** Returns the mound of the chin between the groove above it and its lower edge, where the surface turns backwards. */
function moundOf({ landmarks, radiusAt }: FaceContext, groove: number, across: number): Mound {
  const [corner] = chartPointOf(landmarks.mouthCorner)
  const [, edge] = strongestBend(radiusAt, [0, groove], [0, landmarks.chin - SEARCHED], 1)
  const [top, bottom] = [groove - BELOW_GROOVE, edge + ABOVE_EDGE]
  return {
    centre: [across, (top + bottom) / 2],
    halfWidth: MOUND_WIDTH * corner,
    halfHeight: (top - bottom) / 2,
  }
}

function dimples({ byAge }: FaceContext, rng: FaceRng, { centre, halfWidth, halfHeight }: Mound): Guide[] {
  // The golden angle keeps dimples apart (H. Vogel 1979, A better way to construct the sunflower head).
  const dimpleAt = (i: number, turn: number, out: number): Dimple => {
    const angle = GOLDEN_ANGLE * i + turn
    const radius = Math.sqrt((i + 0.5) / DIMPLES) + out
    return { x: radius * halfWidth * cos(angle), y: radius * halfHeight * sin(angle), radius }
  }
  const mirrored = mirroredDimples(Array.from({ length: DIMPLES }, (_, i) => dimpleAt(i, 0, 0)))
  const draw = (rng: FaceRng, i: number): Guide => {
    const [turn, out] = [rng.across(SCATTER[0]), rng.jitter(SCATTER[1])]
    const own = dimpleAt(i, turn, out)
    const partner = mirrored[i]
    const left = partner === undefined ? { ...own, x: -own.x } : dimpleAt(partner, -turn, out)
    const x = centre[0] + rng.towards(-left.x, own.x)
    const y = centre[1] + rng.towards(left.y, own.y)
    const radius = rng.towards(left.radius, own.radius)
    const direction = Math.PI / 2 + rng.across(Math.PI / 2)
    const halfLength = rng.uniform(0.8, 2)
    const bend = rng.across(0.5) * halfLength
    const [dx, dy] = [halfLength * cos(direction), halfLength * sin(direction)]
    const [bx, by] = [-bend * sin(direction), bend * cos(direction)]
    const width = rng.uniform(3.6, 7.5)
    // Few dimples are deep. Shallow ones show with age.
    const depth = rng.uniform(byAge(-0.4, 0.3), 1)
    return {
      path: bezierPath(
        1,
        [x - dx, y - dy],
        [x - dx / 3 + bx, y - dy / 3 + by],
        [x + dx / 3 + bx, y + dy / 3 + by],
        [x + dx, y + dy],
      ),
      width,
      depth: Math.max(0, STEEPNESS * width * depth * (1.2 - 0.7 * radius)),
      taper: [0.5, 0.5],
      shoulder: [1, 1],
      softness: 1,
      isDimple: true,
    }
  }
  return rng.row(DIMPLES, draw, (i) => mirrored[i]).filter(({ depth }) => depth > 0)
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
