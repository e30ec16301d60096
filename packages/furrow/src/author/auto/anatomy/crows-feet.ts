import { interpolateValues, lerp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { CROWS_FEET_DERMIS, DERMIS, dermisAt } from './dermis.ts'
import {
  degreesOf,
  type FaceContext,
  type FaceRegion,
  fade,
  pullAround,
  type Side,
  type SkinFilm,
} from './region.ts'

/** Distance from the corner of the eye, in millimetres, at which the skin is as thick as at the temple. */
const TEMPLE_DISTANCE = 60
/** Distance, in millimetres, from the corner to the centre of the fan inside the eye, so that the lines at the corner are apart from each other. */
const INSIDE = 6
/** Distances from the corner, in millimetres. The compression starts at the first distance and has full strength at the second. */
const START = [0, 4] as const
/** Number of directions for which a reach of the fan is drawn, and range of the random factors on `reach`. */
const REACHES = 7
const REACH_VARIATION = [0.7, 1.2] as const
/** Distance from the corner, in millimetres, beyond which the compression decreases. */
const FAN_FULL = 18
/** Directions of the lower and the upper edge of the fan, in degrees above the horizontal. */
const FAN = [-42, 37] as const
/** Angle in degrees over which the compression fades out at each edge of the fan. */
const FAN_FADE = 28
/** Distance, in millimetres, by which the flattened patch extends beyond the fan (see `SkinFilm.isFlattened`). */
const BORDER = 8
/** Half the height of the eye's opening, in millimetres. */
const LID_OPENING = 9

/** Returns the region of crow's feet, where the ring muscle around the eye (orbicularis oculi) folds the skin into a fan of lines. */
export function crowsFeet(
  { ageFraction, byAge, densityOf, openingOf, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`crowsFeet${name}`)
  const {
    inner: [inner],
    outer: [corner, up],
  } = openingOf(side)
  const centre = corner - INSIDE
  const fromCentre = ([across, height]: ChartPoint): ChartPoint => [side * across - centre, height - up]
  const reach = INSIDE + byAge(30, 52)
  const reaches = Array.from({ length: REACHES }, () => reach * rng.uniform(...REACH_VARIATION))
  /** Returns the reach in a direction, in degrees above the horizontal. */
  const reachAt = (rise: number) => interpolateValues(reaches, (rise - FAN[0]) / (FAN[1] - FAN[0]))
  const film: SkinFilm = {
    centre: [side * centre, up],
    isFlattened: (point) => {
      const [out, high] = fromCentre(point)
      const half = (corner - inner) / 2
      const isEye = ((out - INSIDE + half) / half) ** 2 + (high / LID_OPENING) ** 2 < 1
      const isLow = high < 0.6 * reach + BORDER
      return !isEye && isLow && out > INSIDE - half && length2(out, high) < reach + BORDER
    },
    weight: (point) => {
      const [out, high] = fromCentre(point)
      const distance = length2(out, high)
      const rise = degreesOf(out, high)
      return (
        fade(distance - INSIDE, ...START) *
        fade(distance, reachAt(rise), INSIDE + FAN_FULL) *
        fade(rise, FAN[1] + FAN_FADE / 2, FAN[1] - FAN_FADE / 2) *
        fade(rise, FAN[0] - FAN_FADE / 2, FAN[0] + FAN_FADE / 2)
      )
    },
    thickness: (point) => {
      const distance = length2(...fromCentre(point))
      return dermisAt(lerp(DERMIS.lid, DERMIS.temple, Math.min(1, distance / TEMPLE_DISTANCE)), ageFraction)
    },
    density: densityOf('crowsFeet'),
    pull: pullAround([side * centre, up]),
    variation: { thickness: 0.16, critical: 0.3, size: 5 },
    noise: rng.film(),
    style: {
      width: byAge(1.45, 1.7),
      depth: 1,
      taper: [0.2, 0.5],
      shoulder: [1, 1],
      softness: byAge(0.8, 0.7),
    },
  }
  return {
    name: `crowsFeet${name}`,
    cause: { [`eyeSquint${name}`]: 0.6, [`cheekSquint${name}`]: 1, [`mouthSmile${name}`]: 0.6 },
    film,
    spacing: filmWavelength(dermisAt(CROWS_FEET_DERMIS, ageFraction)) / film.density,
    creasedFraction: byAge(0.42, 0.85),
    maxDepth: byAge(0.47, 0.72),
    atRest: 0.66,
    reach: 4,
    feather: 6,
  }
}
