import { splineKnots } from '../../../math/spline.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { traceStroke, uvOf } from './traced-stroke.ts'

/** Millimetres by which a spline may miss the line that it is made of: a thirtieth of a fine wrinkle's width. */
export const TOLERANCE = 0.08

/**
 * Makes a stroke a spline, the kind whose points can be moved one by one and across seams. Its line stays where it is, to 0.08 mm; where the
 * texture has no skin, the spline goes on over the gap.
 *
 * @returns the stroke itself if it is a spline, or not on the skin at all.
 */
export function splineOf<S extends Stroke>(stroke: S, skin: LocatedSkin): S {
  if (stroke.curve === 'spline') return stroke
  const line = traceStroke(stroke, skin)
  const distinct = [...line.lengths.keys()].filter((i) => i === 0 || line.lengths[i] > line.lengths[i - 1])
  if (distinct.length < 2) return stroke
  const points = Float64Array.from(distinct.flatMap((i) => [...line.points.subarray(3 * i, 3 * i + 3)]))
  const knots = splineKnots(points, TOLERANCE)
  return { ...stroke, curve: 'spline', points: knots.map((i) => uvOf(line, distinct[i], skin)) }
}
