import { atan2 } from '../../../math/elementary.ts'
import { lerp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { DERMIS, dermisAt } from './dermis.ts'
import {
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  fade,
  pullAround,
  type Side,
  type SkinFilm,
} from './region.ts'

/** Distance from the corner of the eye, in millimetres, at which the skin is as thick as at the temple. */
const TEMPLE_DISTANCE = 60
/** Distance from the corner, in millimetres, at which the fan of lines starts. */
const FAN_START = 1.5
/** Distance from the start of the fan, in millimetres, at which the compression reaches its full value. */
const FAN_GROWTH = 4
/** Distance from the corner, in millimetres, beyond which the compression decreases. */
const FAN_FULL = 12
/** Directions of the lower and the upper edge of the fan, in degrees above the horizontal. */
const FAN = [-64, 36] as const
/** Angle in degrees over which the compression fades out at each edge of the fan. */
const FAN_FADE = 28
/** Width, in millimetres, of the margin around the fan in the patch that is flattened to a plane (see `SkinFilm.isFlattened`). */
const BORDER = 8
/** Half the height of the eye's opening, in millimetres. */
const LID_OPENING = 9

/** Returns the region of crow's feet, where the ring muscle around the eye (orbicularis oculi) folds the skin into a fan of lines. */
export function crowsFeet(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`crowsFeet${name}`)
  const [corner, up] = chartPointOf(landmarks.outerCorner)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const fromCorner = ([across, height]: ChartPoint): ChartPoint => [side * across - corner, height - up]
  const reach = byAge(27, 48)
  const film: SkinFilm = {
    centre: [side * corner, up],
    isFlattened: (point) => {
      const [out, high] = fromCorner(point)
      const half = (corner - inner) / 2
      const isEye = ((out + half) / (half + 1)) ** 2 + (high / LID_OPENING) ** 2 < 1
      const isLow = high < 0.6 * reach + BORDER
      return !isEye && isLow && out > -half && length2(out, high) < reach + BORDER
    },
    weight: (point) => {
      const [out, high] = fromCorner(point)
      const distance = length2(out, high)
      const rise = degreesOf(out, high)
      return (
        fade(distance, FAN_START, FAN_START + FAN_GROWTH) *
        fade(distance, reach, FAN_FULL) *
        fade(rise, FAN[1] + FAN_FADE / 2, FAN[1] - FAN_FADE / 2) *
        fade(rise, FAN[0] - FAN_FADE / 2, FAN[0] + FAN_FADE / 2)
      )
    },
    thickness: (point) => {
      const distance = length2(...fromCorner(point))
      return dermisAt(lerp(DERMIS.lid, DERMIS.temple, Math.min(1, distance / TEMPLE_DISTANCE)), ageFraction)
    },
    pull: pullAround([side * corner, up]),
    variation: { thickness: 0.16, critical: 0.3, size: 5 },
    noise: rng.film(),
    style: {
      width: byAge(1.3, 1.5),
      depth: 1,
      taper: [0.12, 0.12],
      shoulder: [1, 1],
      softness: byAge(0.5, 0.4),
    },
  }
  return {
    name: `crowsFeet${name}`,
    cause: { [`eyeSquint${name}`]: 0.6, [`cheekSquint${name}`]: 1, [`mouthSmile${name}`]: 0.6 },
    film,
    spacing: filmWavelength(dermisAt(lerp(DERMIS.lid, DERMIS.temple, 0.25), ageFraction)),
    creasedFraction: byAge(0.42, 0.85),
    maxDepth: byAge(0.5, 0.85),
    atRest: 0.6,
    reach: 4,
    feather: 6,
  }
}

const degreesOf = (across: number, up: number) => (atan2(up, across) * 180) / Math.PI
