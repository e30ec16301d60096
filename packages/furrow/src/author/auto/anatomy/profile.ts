import { lerp } from '../../../math/scalar.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { FaceContext } from './region.ts'

/** Distance between samples in millimetres. */
const STEP = 0.5

/**
 * Finds the strongest bend of the head's surface along a straight line on the chart: the point farthest from the chord between the ends.
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
  let [best, farthest] = [0.5, 0]
  if (first === undefined || last === undefined) return at(best)
  const steps = Math.ceil(Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])) / STEP)
  for (let i = 1; i < steps; i++) {
    const radius = radiusAt(at(i / steps))
    const distance = radius === undefined ? 0 : sign * (radius - lerp(first, last, i / steps))
    if (distance > farthest) [best, farthest] = [i / steps, distance]
  }
  return at(best)
}
