import { length2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { DERMIS, dermisAt } from './dermis.ts'
import {
  degreesOf,
  type FaceContext,
  type FaceRegion,
  fade,
  pullAround,
  SIDES,
  type Side,
  type SkinFilm,
} from './region.ts'

/** Distances from the inner corner of the eye, in millimetres. With distance, folds fade in across `START`, and out across `END`. */
const START = [3, 8] as const
const END = [22, 34] as const
/** Directions from the corner of the eye, in degrees below the horizontal. Folds start at the first direction and have full strength at the second. */
const UPPER_EDGE = [-14, 10] as const
const CHEEK = [80, 52] as const
/** Distances from the ridge of the nose, in millimetres. Folds start at the first distance and have full strength at the second. */
const RIDGE = [-1, 4] as const
/** Factor on the slope of the folds. With a factor of 1, they would lie on lines through the corner of the eye. */
const FLATTENING = 0.85
/** Distance, in millimetres, by which the flattened patch extends beyond the folds (see `SkinFilm.isFlattened`). */
const BORDER = 6

/** Returns the regions on both sides of the nose, where the nasalis muscle gathers the skin. Their lines run towards the corner of the eye. */
export function nose(context: FaceContext): FaceRegion[] {
  return SIDES.map(([side, name]) => bunnyLines(context, side, name))
}

function bunnyLines(
  { ageFraction, byAge, densityOf, openingOf, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const [corner, up] = openingOf(side).inner
  const thickness = dermisAt(DERMIS.nose, ageFraction)
  const fromCorner = ([across, height]: ChartPoint): ChartPoint => [side * across - corner, height - up]
  const film: SkinFilm = {
    centre: [side * corner, up],
    isFlattened: (point) => {
      const [out, high] = fromCorner(point)
      const distance = length2(out, high)
      return out > -corner - BORDER && out < 0 && distance > 1 && distance < END[1] + BORDER && high < BORDER
    },
    weight: (point) => {
      const [out, high] = fromCorner(point)
      const distance = length2(out, high)
      const fall = degreesOf(-out, -high)
      return (
        fade(distance, ...START) *
        fade(distance, END[1], END[0]) *
        fade(fall, ...UPPER_EDGE) *
        fade(fall, ...CHEEK) *
        fade(out + corner, ...RIDGE)
      )
    },
    thickness: () => thickness,
    density: densityOf('nose'),
    pull: pullAround([side * corner, up], FLATTENING),
    variation: { thickness: 0.3, critical: 0.14, size: 9 },
    noise: rngOf(`nose${name}`).film(),
    style: { width: byAge(1.8, 2.3), depth: 1, taper: [0.5, 0.5], shoulder: [1, 1], softness: 0.85 },
  }
  return {
    name: `nose${name}`,
    cause: { [`noseSneer${name}`]: 1 },
    film,
    spacing: filmWavelength(thickness) / film.density,
    creasedFraction: byAge(0.45, 0.85),
    maxDepth: byAge(0.27, 0.48),
    atRest: 0.15,
    reach: 3,
    feather: 5,
  }
}
