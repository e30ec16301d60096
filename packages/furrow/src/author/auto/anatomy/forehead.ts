import { exp, power } from '../../../math/elementary.ts'
import { clamp } from '../../../math/scalar.ts'
import { unit2 } from '../../../math/vector.ts'
import { filmWavelength } from '../buckling/film.ts'
import { DERMIS, dermisAt } from './dermis.ts'
import {
  chartPointOf,
  type FaceContext,
  type FaceRegion,
  fade,
  SIDES,
  type Side,
  type SkinFilm,
} from './region.ts'

/** Half the width, in millimetres, of the transition between the left and the right areas. */
const MIDDLE = 4
/** Half the width, in millimetres, of the transition between an inner and an outer area. */
const HALVES = 9
/** Distance, in millimetres, by which the flattened patch extends beyond the folds (see `SkinFilm.isFlattened`). */
const BORDER = 8
/** Heights above the brows, in millimetres. The compression starts at the first height and has full strength at the second. */
const LOWER_EDGE = [3, 13] as const
/** Distances below the hairline, in millimetres. The compression starts at the first distance and has full strength at the second. */
const UPPER_EDGE = [0, 16] as const
/**
 * Distances from the middle of the face, divided by the distance of the outer brow. The compression starts at the first distance and has full
 * strength at the second.
 */
const OUTER_EDGE = [1.4, 0.3] as const

/**
 * Returns the regions of the forehead, where the frontalis muscle raises the brows and shortens the skin. The folds dip between the brows and
 * arch over each brow. The two ends of each brow can rise separately, so each of four areas shows a part of the same folds.
 */
export function forehead({ landmarks, ageFraction, byAge, densityOf, rngOf }: FaceContext): FaceRegion[] {
  const inner = chartPointOf(landmarks.innerBrow)
  const outer = chartPointOf(landmarks.outerBrow)
  const brow = (inner[1] + outer[1]) / 2
  const height = landmarks.hairline - brow
  const outerBrow = Math.abs(outer[0])
  const rng = rngOf('forehead')
  const [dipInMiddle, fallAtBrows] = [rng.uniform(1.5, 7), rng.uniform(2, 5)]
  /**
   * Returns the drop of a fold at a point, in millimetres, and its derivative by `across`. The sum of `up` and the drop is constant along a
   * fold: folds dip between the brows and fall towards the temples.
   */
  const dropAt = (across: number, up: number): [drop: number, slope: number] => {
    const t = clamp((up - brow) / height, 0, 1)
    const dip = (1 - 0.7 * t) * dipInMiddle * exp(-((across / 13) ** 2))
    const fall = (fallAtBrows + 5 * t) * power(Math.abs(across) / 50, 2.2)
    const slope = (-2 * across * dip) / 169 + (across === 0 ? 0 : (2.2 * fall) / across)
    return [dip + fall, slope]
  }
  const thickness = dermisAt(DERMIS.forehead, ageFraction)
  const film: SkinFilm = {
    centre: [0, brow],
    isFlattened: ([across, up]) => {
      const level = up + dropAt(across, up)[0]
      return (
        level > brow + LOWER_EDGE[0] - BORDER &&
        up < landmarks.hairline + BORDER &&
        Math.abs(across) < OUTER_EDGE[0] * outerBrow + BORDER
      )
    },
    weight: ([across, up]) => {
      const [drop] = dropAt(across, up)
      const level = up + drop
      return (
        fade(level - brow, ...LOWER_EDGE) *
        fade(landmarks.hairline - level, ...UPPER_EDGE) *
        fade(Math.abs(across) / outerBrow, ...OUTER_EDGE)
      )
    },
    thickness: () => thickness,
    density: densityOf('foreheadInner'),
    pull: ([across, up]) => {
      const [, slope] = dropAt(across, up)
      return unit2(slope, 1)
    },
    evenness: 0.8,
    variation: { thickness: 0.16, critical: 0.22, size: 9 },
    noise: rng.film(),
    style: {
      width: byAge(2.8, 3.5),
      depth: 1,
      taper: [0.35, 0.35],
      shoulder: [1, 1],
      softness: byAge(0.65, 0.5),
    },
  }
  const region = (side: Side, sideName: string, half: 'Inner' | 'Outer'): FaceRegion => ({
    name: `forehead${half}${sideName}`,
    cause:
      half === 'Inner'
        ? { browInnerUp: 1, [`browOuterUp${sideName}`]: 0.5 }
        : { [`browOuterUp${sideName}`]: 1, browInnerUp: 0.4 },
    expression: { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 },
    film,
    spacing: filmWavelength(thickness) / film.density,
    creasedFraction: byAge(0.54, 0.9),
    maxDepth: byAge(0.8, 1.35),
    atRest: 0.3,
    reach: 6,
    feather: 7,
    influence: ([across]) => {
      const ownSide = fade(side * across, -MIDDLE, MIDDLE)
      const outerHalf = fade(side * across - 0.42 * outerBrow, -HALVES, HALVES)
      return ownSide * (half === 'Outer' ? outerHalf : 1 - outerHalf)
    },
  })
  return SIDES.flatMap(([side, name]) => [region(side, name, 'Inner'), region(side, name, 'Outer')])
}
