import { lerp } from '../../../math/scalar.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { FaceContext } from './region.ts'

/** Distance between samples in millimetres. */
const STEP = 0.5
/** Points whose distance from the chord is at least this fraction of the largest distance determine the bend. */
const PEAK = 0.9

/**
 * Finds the strongest bend of the head's surface along a straight line on the chart: the middle of the points that are farthest from the chord
 * between the ends. The result changes continuously with the surface, unlike the farthest point on a mesh, which is always at an edge.
 *
 * @param sign 1 for a ridge, which rises above the chord; -1 for a groove.
 * @returns the midpoint if the surface does not bend that way, or has a hole.
 */
export function strongestBend(
  radiusAt: FaceContext['radiusAt'],
  from: ChartPoint,
  to: ChartPoint,
  sign: 1 | -1,
): ChartPoint {
  const at = (t: number): ChartPoint => [lerp(from[0], to[0], t), lerp(from[1], to[1], t)]
  const [first, last] = [radiusAt(from), radiusAt(to)]
  if (first === undefined || last === undefined) return at(0.5)
  const steps = Math.ceil(Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])) / STEP)
  const distances = Array.from({ length: steps }, (_, i) => {
    const radius = radiusAt(at(i / steps))
    return radius === undefined ? 0 : sign * (radius - lerp(first, last, i / steps))
  })
  const least = PEAK * Math.max(0, ...distances)
  let [sum, weights] = [0, 0]
  for (const [i, distance] of distances.entries()) {
    const weight = Math.max(0, distance - least)
    sum += (weight * i) / steps
    weights += weight
  }
  return at(weights > 0 ? sum / weights : 0.5)
}
