import { splineKnots } from '../../../math/spline.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { traceStroke, uvOf } from './traced-stroke.ts'

/** Maximum distance in millimetres between a spline and the line it replaces. */
export const TOLERANCE = 0.08

/**
 * Converts a stroke (a wrinkle) to a spline, because only the points of a spline can be moved across UV seams. The new line is within 0.08 mm
 * of the old one. If the stroke is interrupted at gaps in the skin, the spline bridges them.
 *
 * @returns the stroke itself if it is already a spline, or is outside the skin.
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
