import { cos, sin } from '../../../math/elementary.ts'
import { type FaceContext, type FaceRegion, type Guide, sampleCurve } from './region.ts'

/** Depth of the first ring below the chin, and distance of the next ones, in millimetres. */
const FIRST = 30
const DISTANCE = 21
/** Range of angles around the axis of the head that a ring spans on each side of the throat, in radians. */
const SPAN = [1.15, 1.6] as const
/** Angle at which the depth of the neck is measured on both sides. The throat between them is uneven. */
const SIDE = 0.9
/** Radius of the head's chart (see `unroll`), in millimetres. */
const CHART_RADIUS = 85
/** Typical radius of a neck, in millimetres. */
const NECK_RADIUS = 45
/** Slope of the rings towards the nape, and maximum random slope towards one side, as tangents. They follow the neck, which leans forwards. */
const RISE = 0.3
const TILT = 0.06
/** Number of points of a ring. */
const POINTS = 24
/** Fraction of length that the skin of the throat loses when the head bends. Blendshapes of faces do not move it. */
const COMPRESSION = 0.12

/** Returns the region of the neck, with rings around its cylinder. */
export function neck({ landmarks, byAge, radiusAt, rngOf }: FaceContext): FaceRegion {
  const rng = rngOf('neck')
  const rings = Math.round(byAge(2, 3))
  const guides = Array.from({ length: rings }, (_, i): Guide => {
    const up = landmarks.chin - FIRST - DISTANCE * i + rng.jitter(4)
    const left = rng.uniform(...SPAN)
    const right = rng.towards(left, rng.uniform(...SPAN))
    const [tilt, wave, shift] = [rng.across(TILT), rng.jitter(1.2), rng.across(1.5)]
    const radius = (angle: number) => radiusAt([CHART_RADIUS * angle, up]) ?? NECK_RADIUS
    const depth = radius(0) - (cos(SIDE) * (radius(SIDE) + radius(-SIDE))) / 2
    const rise = (RISE * depth) / (1 - cos(SIDE))
    return {
      path: sampleCurve(POINTS, (t) => {
        const angle = -right + (left + right) * t
        const uneven = wave * cos(3 * angle + shift) + tilt * NECK_RADIUS * sin(angle)
        return [CHART_RADIUS * angle, up + rise * (1 - cos(angle)) + uneven]
      }),
      width: byAge(4, 5.6),
      depth: rng.uniform(0.65, 1),
      depths: [0.6, 0.85, 1, 0.9, 1, 0.85, 0.6],
      taper: [0.25, 0.25],
      shoulder: [0.8, 0.8],
      softness: 0.95,
    }
  })
  return {
    name: 'neck',
    cause: { jawOpen: 1 },
    guides,
    spacing: DISTANCE,
    creasedFraction: byAge(0.15, 0.7),
    maxDepth: byAge(0.2, 1.4),
    atRest: 0.6,
    assumedCompression: COMPRESSION,
    reach: 7,
    feather: 8,
  }
}
