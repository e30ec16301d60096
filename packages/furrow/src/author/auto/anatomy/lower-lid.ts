import { lerp } from '../../../math/scalar.ts'
import { unit2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { DERMIS, dermisAt } from './dermis.ts'
import { type FaceContext, type FaceRegion, fade, type Side, type SkinFilm } from './region.ts'

/** Distances below the margin of the lower lid, in millimetres. Downwards, folds fade in across `UPPER_EDGE`, and out across `LOWER_EDGE`. */
const UPPER_EDGE = [1, 4] as const
const LOWER_EDGE = [9, 18] as const
/** Distances from each corner towards the middle of the eye, mm. Folds start at the first distance and have full strength at the second. */
const INNER_EDGE = [-8, 0] as const
const OUTER_EDGE = [-4, 3] as const
/** Distance, in millimetres, by which the flattened patch extends below and beside the folds (see `SkinFilm.isFlattened`). */
const BORDER = 7

/** Returns the region below the lower lid: skin that the cheek and the ring muscle around the eye (orbicularis oculi) push up. */
export function lowerLid(
  { ageFraction, byAge, densityOf, openingOf, rngOf }: FaceContext,
  side: Side,
  name: string,
): FaceRegion {
  const rng = rngOf(`underEye${name}`)
  const { inner, outer, lowest } = openingOf(side)
  const width = outer[0] - inner[0]
  const sag = (inner[1] + outer[1]) / 2 - lowest
  const thickness = dermisAt(DERMIS.lid, ageFraction)
  /** Returns the height and the slope of the margin of the lower lid: a parabola through the corners of the eye. */
  const marginAt = (across: number): readonly [up: number, slope: number] => {
    const t = (across - inner[0]) / width
    const up = lerp(inner[1], outer[1], t) - 4 * sag * t * (1 - t)
    return [up, (outer[1] - inner[1] - 4 * sag * (1 - 2 * t)) / width]
  }
  /** Returns a point's distances from the inner corner, from the outer corner (both positive between the corners), and below the margin. */
  const placeOf = ([across, up]: ChartPoint) =>
    [side * across - inner[0], outer[0] - side * across, marginAt(side * across)[0] - up] as const
  const film: SkinFilm = {
    centre: [(side * (inner[0] + outer[0])) / 2, lowest],
    isFlattened: (point) => {
      const [fromInner, fromOuter, below] = placeOf(point)
      return (
        fromInner > INNER_EDGE[0] - BORDER &&
        fromOuter > OUTER_EDGE[0] - BORDER &&
        below > 0 &&
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
    density: densityOf('underEye'),
    pull: ([across]) => unit2(-side * marginAt(side * across)[1], 1),
    variation: { thickness: 0.16, critical: 0.2, size: 5 },
    noise: rng.film(),
    style: { width: byAge(1.3, 1.6), depth: 1, taper: [0.4, 0.4], shoulder: [0.9, 0.9], softness: 0.75 },
  }
  return {
    name: `underEye${name}`,
    cause: { [`eyeSquint${name}`]: 1, [`cheekSquint${name}`]: 0.7 },
    film,
    spacing: filmWavelength(thickness) / film.density,
    creasedFraction: byAge(0.5, 0.85),
    maxDepth: byAge(0.2, 0.4),
    atRest: 0.5,
    reach: 2.5,
    feather: 4,
  }
}
