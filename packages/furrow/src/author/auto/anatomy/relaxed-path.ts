import type { ChartPoint } from '../surface/head-chart.ts'

/** Number of iterations and their relative step. Expressions shorten skin by less than half, so the error shrinks in each iteration. */
const ITERATIONS = 16
const STEP = 0.7

/**
 * Returns the path at rest that an expression moves to a given path. Lines that an expression shows are smooth in the expression, and not
 * necessarily at rest.
 *
 * @param moved result of `FaceContext.motionOf`.
 */
export function relaxedPath(
  moved: (point: ChartPoint) => ChartPoint,
  path: readonly ChartPoint[],
): ChartPoint[] {
  return path.map((target) => {
    let [across, up] = target
    for (let i = 0; i < ITERATIONS; i++) {
      const reached = moved([across, up])
      across += STEP * (target[0] - reached[0])
      up += STEP * (target[1] - reached[1])
    }
    return [across, up]
  })
}
