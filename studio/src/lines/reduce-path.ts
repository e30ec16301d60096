import { splineKnots } from 'furrow/internal'

/** A point where a pointer was on the skin. */
export interface PathPoint {
  /** At rest, in millimetres. */
  readonly position: readonly [x: number, y: number, z: number]
  readonly uv: readonly [u: number, v: number]
}

/** Millimetres by which a line may miss the way of the pointer: less than a hand's tremor. */
const TOLERANCE = 0.7
/** Millimetres from point to point, at least: pointers report many in one texel. */
const STEP = 0.3
/** Millimetres below which a gesture is a click. */
const SHORTEST = 2

/**
 * Reduces the way of a pointer to the few points that a spline needs to follow it: points are added where the spline misses it most, as
 * Ramer (1972) and Douglas and Peucker (1973) do with straight lines.
 *
 * @returns none where the way is too short for a line.
 */
export function reducePath(path: readonly PathPoint[]): PathPoint[] {
  const distinct: PathPoint[] = []
  for (const point of path) {
    const last = distinct.at(-1)
    if (!last || distance(last, point) >= STEP) distinct.push(point)
  }
  if (distinct.length > 1) distinct[distinct.length - 1] = path[path.length - 1]
  const away = distinct.map((point) => distance(distinct[0], point))
  const farthest = away.indexOf(Math.max(...away))
  if (!(away[farthest] >= SHORTEST)) return []
  const positions = Float64Array.from(distinct.flatMap(({ position }) => position))
  // The ends of a way that comes back are one point, through which no spline goes.
  const ends = [...new Set([0, farthest, distinct.length - 1])]
  return splineKnots(positions, TOLERANCE, ends).map((i) => distinct[i])
}

function distance(a: PathPoint, b: PathPoint): number {
  return Math.hypot(...a.position.map((value, k) => b.position[k] - value))
}
