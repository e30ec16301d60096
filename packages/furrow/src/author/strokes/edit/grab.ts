import { smoothstep } from '../../../math/scalar.ts'
import type { Stroke, Uv } from '../document.ts'
import { type Fork, type ForkedStrokes, pointAt } from './forks.ts'
import { moveOver, placeAt } from './over-skin.ts'
import { splineOf } from './spline-of.ts'
import type { StrokeLine, StrokeLines } from './stroke-lines.ts'

/** Moves a point of a stroke, given by its index in the spline that `splineOf` returns for the stroke. */
export function withPoint<S extends Stroke>(stroke: S, knot: number, uv: Uv, { skin }: StrokeLines): S {
  const spline = splineOf(stroke, skin)
  return { ...spline, points: spline.points.with(knot, uv) }
}

/**
 * Returns the fraction of a grabbed point's motion that each point of a line makes: 1 at the grabbed point, and a smoothstep to 0 at `radius`.
 *
 * @param knot index of the grabbed point in `line.knots`.
 * @param radius arc length, millimetres. 0: only the grabbed point moves.
 * @param held ends of the line that stay; 0: start, 1: end. On their side, the motion falls to 0 at the end at the latest.
 */
export function grabWeights(
  { lengths, knots }: Pick<StrokeLine, 'lengths' | 'knots'>,
  knot: number,
  radius: number,
  held: readonly (0 | 1)[] = [],
): number[] {
  const centre = lengths[knots[knot]]
  const room = [centre, lengths[lengths.length - 1] - centre]
  const reach = room.map((length, end) => (held.includes(end as 0 | 1) ? Math.min(radius, length) : radius))
  return knots.map((place, i) => {
    if (i === knot) return 1
    const far = Math.abs(lengths[place] - centre) / reach[i < knot ? 0 : 1]
    return 1 - smoothstep(far)
  })
}

/** Returns the ends of a stroke that are in forks, except `moved`. 0: start, 1: end. */
export function heldEnds(forks: readonly Fork[], index: number, moved?: Fork | null): (0 | 1)[] {
  return forks.flatMap((fork) =>
    fork === moved ? [] : fork.ends.flatMap(({ stroke, end }) => (stroke === index ? end : [])),
  )
}

/**
 * Returns the vector from a position to UV coordinates, in millimetres. Returns null if there is no skin at the UV coordinates.
 *
 * @param from xyz, millimetres.
 */
export function stepTo(from: ArrayLike<number>, uv: Uv, { skin }: StrokeLines): Float64Array | null {
  return placeAt(uv, skin)?.position.map((value, k) => value - from[k]) ?? null
}

/**
 * Moves the points of a stroke over the skin.
 *
 * @param step motion of points with the weight 1, millimetres.
 * @param weights result of `grabWeights`.
 */
export function grabStroke<S extends Stroke>(
  stroke: S,
  step: Float64Array,
  weights: readonly number[],
  { skin }: StrokeLines,
): S {
  const spline = splineOf(stroke, skin)
  const points = spline.points.map((uv, i) => {
    const place = weights[i] > 0 ? placeAt(uv, skin) : null
    if (!place) return uv
    return moveOver(
      place,
      step.map((value) => weights[i] * value),
      skin,
    )
  })
  return { ...spline, points }
}

/**
 * Moves a point of a stroke to a position, and its neighbours in proportion to `grabWeights`. Ends in forks stay.
 *
 * @param index index of the stroke.
 * @param knot index of the point in the stroke's spline.
 * @param moved fork that moves with the point, or null.
 */
export function grabPoint<S extends Stroke>(
  { strokes, forks, lines }: ForkedStrokes<S>,
  index: number,
  knot: number,
  { uv, radius, moved }: { uv: Uv; radius: number; moved?: Fork | null },
): S {
  const stroke = strokes[index]
  const line = lines.lineOf(stroke)
  const step = line && radius > 0 ? stepTo(pointAt(line, line.knots[knot]), uv, lines) : null
  if (!line || !step) return withPoint(stroke, knot, uv, lines)
  const weights = grabWeights(line, knot, radius, heldEnds(forks, index, moved))
  return withPoint(grabStroke(stroke, step, weights, lines), knot, uv, lines)
}
