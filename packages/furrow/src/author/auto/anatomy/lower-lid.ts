import { unit2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { DERMIS, dermisAt } from './dermis.ts'
import { chartPointOf, type FaceContext, type FaceRegion, fade, type Side, type SkinFilm } from './region.ts'

/** Distances below the centre of the eye, in millimetres. Downwards, folds fade in across `UPPER_EDGE`, and out across `LOWER_EDGE`. */
const UPPER_EDGE = [9, 13] as const
const LOWER_EDGE = [17, 27] as const
/** Distances from each corner of the eye towards the middle of the eye, in millimetres. Folds fade in from the first to the second. */
const INNER_EDGE = [-1, 7] as const
const OUTER_EDGE = [0, 8] as const
/** Ratio of height to width of an oval around the eye. The folds follow its lower half. */
const OVAL = 0.62
/** Distance, in millimetres, by which the flattened patch extends below and beside the folds (see `SkinFilm.isFlattened`). */
const BORDER = 7
/** Distance, in millimetres, by which the flattened patch extends above the folds, onto the lid. */
const LID_BORDER = 2

/** Returns the region below the lower lid: skin that the cheek and the ring muscle around the eye (orbicularis oculi) push up. */
export function lowerLid(
  { landmarks, ageFraction, byAge, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`underEye${name}`)
  const [inner] = chartPointOf(landmarks.innerCorner)
  const [outer] = chartPointOf(landmarks.outerCorner)
  const eye = landmarks.eye[1]
  const middle = (inner + outer) / 2
  const thickness = dermisAt(DERMIS.lid, ageFraction)
  /** Returns a point's distances from the inner corner, from the outer corner (both positive between the corners), and below the eye. */
  const placeOf = ([across, up]: ChartPoint) =>
    [side * across - inner, outer - side * across, eye - up] as const
  const film: SkinFilm = {
    centre: [side * middle, eye],
    isFlattened: (point) => {
      const [fromInner, fromOuter, below] = placeOf(point)
      return (
        fromInner > INNER_EDGE[0] - BORDER &&
        fromOuter > OUTER_EDGE[0] - BORDER &&
        below > UPPER_EDGE[0] - LID_BORDER &&
        below < LOWER_EDGE[1] + BORDER
      )
    },
    weight: (point) => {
      const [fromInner, fromOuter, below] = placeOf(point)
      return (
        fade(below, ...UPPER_EDGE) *
        fade(below, LOWER_EDGE[1], LOWER_EDGE[0]) *
        fade(fromInner, ...INNER_EDGE) *
        fade(fromOuter, ...OUTER_EDGE)
      )
    },
    thickness: () => thickness,
    pull: ([across, up]) => unit2((across - side * middle) * OVAL * OVAL, up - eye),
    variation: { thickness: 0.16, critical: 0.3, size: 5 },
    noise: rng.film(),
    style: { width: byAge(1.3, 1.6), depth: 1, taper: [0.2, 0.2], shoulder: [0.9, 0.9], softness: 0.6 },
  }
  return {
    name: `underEye${name}`,
    cause: { [`eyeSquint${name}`]: 1, [`cheekSquint${name}`]: 0.7 },
    film,
    spacing: filmWavelength(thickness),
    creasedFraction: byAge(0.4, 0.75),
    maxDepth: byAge(0.2, 0.4),
    atRest: 0.5,
    reach: 2.5,
    feather: 4,
  }
}
