import { lerp } from './scalar.ts'
import { length3 } from './vector.ts'

/**
 * Factor slightly below 1. A search multiplies distances by this factor before it skips segments, so that rounding errors never skip the nearest
 * segment.
 */
const ROUNDED = 1 - 1e-6

/**
 * Evaluates a segment of a centripetal Catmull-Rom spline at `t`, 0..1, with the pyramidal algorithm of Barry and Goldman (1988). The first
 * and last segments need a point beyond the end of the spline. This point is the neighbour of the end point, mirrored at the end point.
 *
 * @param points packed xyz of at least two points. Consecutive points must differ.
 * @param segment index of the segment's first point.
 */
export function splineAt(out: Float64Array, points: ArrayLike<number>, segment: number, t: number): void {
  const t1 = knotAt(points, segment - 1)
  const t2 = t1 + knotAt(points, segment)
  const t3 = t2 + knotAt(points, segment + 1)
  const x = lerp(t1, t2, t)
  for (let k = 0; k < 3; k++) {
    const p0 = pointAt(points, segment - 1, k)
    const p1 = pointAt(points, segment, k)
    const p2 = pointAt(points, segment + 1, k)
    const p3 = pointAt(points, segment + 2, k)
    const a1 = lerp(p0, p1, x / t1)
    const a2 = lerp(p1, p2, (x - t1) / (t2 - t1))
    const a3 = lerp(p2, p3, (x - t2) / (t3 - t2))
    const b1 = lerp(a1, a2, x / t2)
    const b2 = lerp(a2, a3, (x - t1) / (t3 - t1))
    out[k] = lerp(b1, b2, (x - t1) / (t2 - t1))
  }
}

/** Returns coordinate `k` of point `i`. Point -1 is point 1 mirrored at point 0. The point after the last one is mirrored in the same way. */
function pointAt(points: ArrayLike<number>, i: number, k: number): number {
  const last = points.length / 3 - 1
  if (i < 0) return 2 * points[k] - points[3 + k]
  if (i > last) return 2 * points[3 * last + k] - points[3 * last - 3 + k]
  return points[3 * i + k]
}

/**
 * Returns the knot interval between point `i` and the next point. In the centripetal parametrisation, this interval is the square root of the
 * distance between the two points. The spline then has no cusps or loops within a segment (Yuksel et al. 2011).
 */
function knotAt(points: ArrayLike<number>, i: number): number {
  const x = pointAt(points, i + 1, 0) - pointAt(points, i, 0)
  const y = pointAt(points, i + 1, 1) - pointAt(points, i, 1)
  const z = pointAt(points, i + 1, 2) - pointAt(points, i, 2)
  return Math.sqrt(length3(x, y, z))
}

/**
 * Chooses a few points of a polyline, such that the spline through the chosen points is close to the polyline.
 *
 * @param points packed xyz of at least two points. Consecutive points must differ.
 * @param tolerance maximum distance of the spline from the polyline.
 * @param chosen indices of points that must be chosen, in ascending order. They include the first and the last point.
 * @returns indices of the chosen points, in ascending order.
 */
export function splineKnots(
  points: Float64Array,
  tolerance: number,
  chosen: readonly number[] = [0, points.length / 3 - 1],
): number[] {
  let knots = [...chosen]
  const out = new Float64Array(3)
  const longest = longestSegment(points)
  for (;;) {
    const through = Float64Array.from(knots.flatMap((i) => [...points.subarray(3 * i, 3 * i + 3)]))
    const added: number[] = []
    for (let segment = 0; segment + 1 < knots.length; segment++) {
      const [from, to] = [knots[segment], knots[segment + 1]]
      let [worst, farthest] = [-1, tolerance]
      for (let i = from + 1; i < to; i++) {
        splineAt(out, through, segment, (i - from) / (to - from))
        const distance = distanceToLine(points, from, to, out, i, longest, farthest)
        if (distance > farthest) [worst, farthest] = [i, distance]
      }
      if (worst >= 0) added.push(worst)
    }
    if (added.length === 0) return knots
    knots = [...knots, ...added].sort((a, b) => a - b)
  }
}

/**
 * Computes the distance from a position to the part of a polyline between the points `from` and `to`. The search begins at the segment after
 * point `first`, and continues in both directions. It stops once the distance is known to be at most `enough`.
 *
 * @param longest length of the longest segment. The distances to two neighbouring segments differ by at most this length.
 */
function distanceToLine(
  points: Float64Array,
  from: number,
  to: number,
  position: Float64Array,
  first: number,
  longest: number,
  enough: number,
): number {
  let nearest = Infinity
  for (let i = first; i < to && nearest > enough; ) {
    const distance = distanceToSegment(points, i, position)
    nearest = Math.min(nearest, distance)
    i += Math.max(1, Math.floor((ROUNDED * distance - nearest) / longest))
  }
  for (let i = first - 1; i >= from && nearest > enough; ) {
    const distance = distanceToSegment(points, i, position)
    nearest = Math.min(nearest, distance)
    i -= Math.max(1, Math.floor((ROUNDED * distance - nearest) / longest))
  }
  return nearest
}

/** Computes the distance from a position to the segment between point `point` of a polyline and the next point. */
export function distanceToSegment(points: Float64Array, point: number, position: Float64Array): number {
  let along = 0
  let square = 0
  let offset = 0
  for (let k = 0; k < 3; k++) {
    const step = points[3 * point + 3 + k] - points[3 * point + k]
    const away = position[k] - points[3 * point + k]
    along += step * away
    square += step * step
    offset += away * away
  }
  const t = Math.min(1, Math.max(0, along / (square || 1)))
  return Math.sqrt(Math.max(0, offset - 2 * t * along + t * t * square))
}

function longestSegment(points: Float64Array): number {
  let longest = 0
  for (let i = 0; i + 5 < points.length; i += 3)
    longest = Math.max(
      longest,
      length3(points[i + 3] - points[i], points[i + 4] - points[i + 1], points[i + 5] - points[i + 2]),
    )
  return longest
}
