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
  SIDES,
  type Side,
  type SkinFilm,
} from './region.ts'

/** Distances from the inner corner of the eye, in millimetres. Folds fade in over the first range, and out over the second. */
const START = [3, 7] as const
const END = [20, 34] as const
/** Distances below the corner of the eye, in millimetres. Folds fade in from the first to the second. */
const UPPER_EDGE = [-4, 6] as const
/** Distances from the middle of the face, in millimetres. Beside the ridge of the nose, folds fade in from the first to the second. */
const RIDGE = [2.5, 6.5] as const
/** Distances from the inner corner of the eye towards the cheek, in millimetres. Folds fade in from the first to the second. */
const CHEEK = [4, -3] as const
/** Factor on the slope of the folds. With a factor of 1, they would lie on lines through the corner of the eye. */
const FLATTENING = 0.3
/** Width, in millimetres, of the margin around the folds in the patch that is flattened to a plane (see `SkinFilm.isFlattened`). */
const BORDER = 6

/** Returns the regions on both sides of the nose, where the nasalis muscle gathers the skin. Their lines run towards the corner of the eye. */
export function nose(context: FaceContext): FaceRegion[] {
  return SIDES.map(([side, name]) => bunnyLines(context, side, name))
}

function bunnyLines(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const [corner, up] = chartPointOf(landmarks.innerCorner)
  const thickness = dermisAt(DERMIS.nose, ageFraction)
  const fromCorner = ([across, height]: ChartPoint): ChartPoint => [side * across - corner, height - up]
  const film: SkinFilm = {
    centre: [side * corner, up],
    isFlattened: (point) => {
      const [out, high] = fromCorner(point)
      const distance = length2(out, high)
      return (
        out > -corner - BORDER &&
        out < CHEEK[0] + BORDER &&
        distance > 1 &&
        distance < END[1] + BORDER &&
        high < BORDER
      )
    },
    weight: (point) => {
      const [out, high] = fromCorner(point)
      const distance = length2(out, high)
      return (
        fade(distance, ...START) *
        fade(distance, END[1], END[0]) *
        fade(-high, ...UPPER_EDGE) *
        fade(out + corner, ...RIDGE) *
        fade(out, ...CHEEK)
      )
    },
    thickness: () => thickness,
    pull: pullAround([side * corner, up], FLATTENING),
    variation: { thickness: 0.2, critical: 0.15, size: 5 },
    noise: rngOf(`nose${name}`).film(),
    style: { width: byAge(2, 2.5), depth: 1, taper: [0.25, 0.25], shoulder: [0.9, 0.9], softness: 0.65 },
  }
  return {
    name: `nose${name}`,
    cause: { [`noseSneer${name}`]: 1 },
    film,
    spacing: filmWavelength(thickness),
    creasedFraction: byAge(0.45, 0.85),
    maxDepth: byAge(0.5, 0.9),
    atRest: 0.15,
    reach: 3,
    feather: 5,
  }
}
