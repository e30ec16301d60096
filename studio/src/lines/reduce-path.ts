import { splineKnots } from 'furrow/internal'

/** Pointer position on the skin. */
export interface PathPoint {
  /** Position on the skin at rest, millimetres. */
  readonly position: readonly [x: number, y: number, z: number]
  readonly uv: readonly [u: number, v: number]
}

/** Maximum deviation of the spline from the pointer path, millimetres. This is less than the tremor of a hand. */
const TOLERANCE = 0.7
/** Minimum distance between points of the path, millimetres. Pointers send more points than needed. */
const STEP = 0.3
/** Minimum distance between the start and the farthest point of a path, millimetres. A shorter gesture is a click. */
const MIN_EXTENT = 2

/**
 * Reduces a pointer path to the few points that a spline needs. Adds points where the spline deviates most from the
 * path, as Ramer (1972) and Douglas and Peucker (1973) do for straight lines.
 *
 * @returns an empty array if the path is too short.
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
  if (!(away[farthest] >= MIN_EXTENT)) return []
  const positions = Float64Array.from(distinct.flatMap(({ position }) => position))
  // The ends of a closed path coincide, but a spline needs two different points. So include the farthest point.
  const ends = [...new Set([0, farthest, distinct.length - 1])]
  return splineKnots(positions, TOLERANCE, ends).map((i) => distinct[i])
}

function distance(a: PathPoint, b: PathPoint): number {
  return Math.hypot(...a.position.map((value, k) => b.position[k] - value))
}
