import { dot } from '../../../math/vector.ts'
import { add, crossed, scale, subtract, unit } from '../../../math/vector3.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { FaceContext } from './region.ts'

/** Maximum distance between a path and the crease that it moves to, in millimetres, and step of the search. */
const REACH = 9
const STEP = 0.5
/** Distances, in millimetres, over which the bend of the skin is measured. */
const SPANS = [3, 6] as const
/** Reward for a bend of 1 per millimetre. Sharper bends than `SHARPEST` get no further reward. */
const REWARD = 8
const SHARPEST = 0.35
/** Distances in millimetres that cost 1: of a point from the path, and of a point's shift from the shift of the point before. */
const FAR = 7
const UNEVEN = 1.2

/**
 * Moves a path on the skin sidewards into the crease that an expression makes in the mesh, if there is one nearby. Artists sculpt deep creases
 * into blendshapes. A line beside such a crease would be its twin. The first point of the path stays where it is.
 *
 * The shifts minimise the sum of their costs (dynamic programming, Bellman 1957).
 *
 * @param posedAt result of `FaceContext.posedBy` for the expression.
 * @param path points on the head's chart.
 */
export function intoCrease(
  posedAt: ReturnType<FaceContext['posedBy']>,
  path: readonly ChartPoint[],
): ChartPoint[] {
  const shifts = Array.from({ length: (2 * REACH) / STEP + 1 }, (_, i) => i * STEP - REACH)
  const sides = path.map((_, i) => sidewards(path, i))
  const shifted = (i: number, by: number): ChartPoint => [
    path[i][0] + by * sides[i][0],
    path[i][1] + by * sides[i][1],
  ]
  let costs = shifts.map((shift) => (shift === 0 ? 0 : Infinity))
  const origins: number[][] = []
  for (let i = 1; i < path.length; i++) {
    const origin: number[] = []
    costs = shifts.map((shift, k) => {
      const bend = bendAt(posedAt, shifted(i, shift), sides[i])
      const own = (shift / FAR) ** 2 - REWARD * Math.min(SHARPEST, Math.max(0, bend))
      const totals = costs.map((cost, j) => cost + ((shift - shifts[j]) / UNEVEN) ** 2)
      const least = Math.min(...totals)
      origin[k] = totals.indexOf(least)
      return own + least
    })
    origins.push(origin)
  }
  const chosen = [costs.indexOf(Math.min(...costs))]
  for (const origin of origins.reverse()) chosen.unshift(origin[chosen[0]])
  const found = chosen.map((k) => shifts[k])
  return found.map((shift, i) => {
    const [before, after] = [found[i - 1] ?? shift, found[i + 1] ?? shift]
    return i === 0 ? path[0] : shifted(i, (before + 2 * shift + after) / 4)
  })
}

/** Returns the unit vector to the right of a path at one of its points. */
function sidewards(path: readonly ChartPoint[], i: number): ChartPoint {
  const [from, to] = [path[Math.max(0, i - 1)], path[Math.min(path.length - 1, i + 1)]]
  const [x, y] = [to[0] - from[0], to[1] - from[1]]
  const length = Math.sqrt(x * x + y * y) || 1
  return [y / length, -x / length]
}

/** Returns the curvature of the posed skin along a direction on the chart, in 1/mm: positive in creases; 0 where skin is missing. */
function bendAt(posedAt: ReturnType<FaceContext['posedBy']>, point: ChartPoint, side: ChartPoint): number {
  const at = (aside: number, ahead: number) =>
    posedAt([point[0] + aside * side[0] - ahead * side[1], point[1] + aside * side[1] + ahead * side[0]])
  const bends = SPANS.map((span) => {
    const [here, left, right, behind, before] = [
      at(0, 0),
      at(-span, 0),
      at(span, 0),
      at(0, -span),
      at(0, span),
    ]
    if (!here || !left || !right || !behind || !before) return 0
    const across = subtract(right, left)
    const out = crossed(across, subtract(before, behind))
    const length = dot(across, across) / 4
    if (!(dot(out, out) > 0 && length > 0)) return 0
    const rise = subtract(add(left, right), scale(here, 2))
    return dot(rise, unit(out)) / length
  })
  return bends.reduce((a, b) => a + b, 0) / bends.length
}
