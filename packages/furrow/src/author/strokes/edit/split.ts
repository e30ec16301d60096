import { clamp, lerp } from '../../../math/scalar.ts'
import { splineKnots } from '../../../math/spline.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { depthFactor, taperAt } from '../lay-out.ts'
import { checkIndex } from './points.ts'
import { splineOf, TOLERANCE } from './spline-of.ts'
import { knotsOf, traceStroke, uvOf } from './traced-stroke.ts'

/** Approximate spacing of the depth factors (`Stroke.depths`) of a part, in millimetres. */
const FACTOR_SPACING = 1
/** Maximum number of depth factors per stroke. */
const MAX_FACTORS = 256

/**
 * Splits a stroke (a wrinkle) in two at one of its points. Points are added so that both parts stay within 0.08 mm of the original line. Both
 * parts keep the stroke's depths and do not taper at the cut. The second part has a different waviness, because its random seed is derived
 * from its first point.
 *
 * @param index index of an inner point in the spline that `splineOf` returns for the stroke.
 * @returns both parts as splines; the first one contains the start of the stroke.
 * @throws FurrowError if the index is out of range, or is the index of an end point.
 */
export function splitStroke<S extends Stroke>(stroke: S, index: number, skin: LocatedSkin): [S, S] {
  const spline = splineOf(stroke, skin)
  checkIndex('splitStroke', index, 1, spline.points.length - 2)
  const line = traceStroke(spline, skin)
  const knots = knotsOf(spline, line, skin)
  const part = (first: number, last: number): S => {
    const points = splinePoints(spline, first, last)
    const [start, end] = [line.lengths[knots[first]], line.lengths[knots[last]]]
    // A part outside the skin has no length, so its depths and tapers cannot be computed.
    if (!(end > start)) return { ...spline, points }
    return { ...spline, points, ...shapeOf(spline, start, end, line.lengths.at(-1) ?? end) }
  }
  function splinePoints(of: S, first: number, last: number): S['points'] {
    const own = knots.slice(first, last + 1)
    if (own.some((knot, i) => i > 0 && knot <= own[i - 1])) return of.points.slice(first, last + 1)
    const section = line.points.subarray(3 * own[0], 3 * own[own.length - 1] + 3)
    const added = splineKnots(
      section,
      TOLERANCE,
      own.map((knot) => knot - own[0]),
    )
    return added.map((i) => {
      const at = own.indexOf(own[0] + i)
      return at >= 0 ? of.points[first + at] : uvOf(line, own[0] + i, skin)
    })
  }
  return [part(0, index), part(index, spline.points.length - 1)]
}

/** Computes tapers and depth factors of the part of a stroke between the arc lengths `start` and `end`. Lengths are in millimetres. */
function shapeOf(
  { depths, taper }: Stroke,
  start: number,
  end: number,
  total: number,
): Pick<Stroke, 'taper' | 'depths'> {
  const length = end - start
  const own: Stroke['taper'] = [
    start > 0 ? 0 : Math.min(1, (taper[0] * total) / length),
    end < total ? 0 : Math.min(1, (taper[1] * total) / length),
  ]
  const isWithin =
    taper[0] * total <= (start > 0 ? start : length) &&
    taper[1] * total <= (end < total ? total - end : length)
  if (!depths && isWithin) return { taper: own }
  const count = clamp(Math.ceil(length / FACTOR_SPACING) + 1, 2, MAX_FACTORS)
  return {
    taper: own,
    depths: Array.from({ length: count }, (_, i) => {
      // At the exact ends, the tapers of the stroke and of the part can both be zero, so that their ratio is undefined.
      const t = clamp(i / (count - 1), 1e-3, 1 - 1e-3)
      const whole = lerp(start, end, t) / total
      return clamp((depthFactor(depths, whole) * taperAt(whole, taper)) / (taperAt(t, own) || 1), 0, 1)
    }),
  }
}
