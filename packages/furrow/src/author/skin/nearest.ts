import { cornersOf, type SkinSurface, triangleBox } from './surface.ts'

/**
 * Finds the point of a surface nearest to a position (Ericson, Real-Time Collision Detection, 5.1.5).
 *
 * @param weights receives the barycentric coordinates of the nearest point.
 * @returns index of the triangle that contains the nearest point.
 */
export function nearestOnSurface(
  surface: SkinSurface,
  position: ArrayLike<number>,
  weights: Float64Array,
): number {
  const [low, high, candidate] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  let [nearest, least] = [-1, Infinity]
  for (let triangle = 0; triangle < surface.skinTriangles.length; triangle++) {
    triangleBox(surface, triangle, low, high)
    let square = 0
    for (let k = 0; k < 3; k++) square += Math.max(0, low[k] - position[k], position[k] - high[k]) ** 2
    if (square >= least) continue
    square = nearestOnTriangle(surface, triangle, position, candidate)
    if (square >= least) continue
    least = square
    nearest = triangle
    weights.set(candidate)
  }
  return nearest
}

/** Finds the point of a triangle nearest to a position. Stores its barycentric coordinates in `weights`, and returns the squared distance. */
function nearestOnTriangle(
  surface: SkinSurface,
  triangle: number,
  position: ArrayLike<number>,
  weights: Float64Array,
): number {
  const { points } = surface
  const corners = cornersOf(surface, triangle)
  const at = (i: number) => [0, 1, 2].map((k) => points[3 * corners[i] + k])
  const [a, b, c] = [at(0), at(1), at(2)]
  const [ab, ac] = [minus(b, a), minus(c, a)]
  const [fromA, fromB, fromC] = [minus(position, a), minus(position, b), minus(position, c)]
  const [d1, d2] = [dot3(ab, fromA), dot3(ac, fromA)]
  const [d3, d4] = [dot3(ab, fromB), dot3(ac, fromB)]
  const [d5, d6] = [dot3(ab, fromC), dot3(ac, fromC)]
  const [wa, wb, wc] = [d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2]
  if (d1 <= 0 && d2 <= 0) weights.set([1, 0, 0])
  else if (d3 >= 0 && d4 <= d3) weights.set([0, 1, 0])
  else if (d6 >= 0 && d5 <= d6) weights.set([0, 0, 1])
  else if (wc <= 0 && d1 >= 0 && d3 <= 0) weights.set([1 - d1 / (d1 - d3), d1 / (d1 - d3), 0])
  else if (wb <= 0 && d2 >= 0 && d6 <= 0) weights.set([1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)])
  else if (wa <= 0 && d4 >= d3 && d5 >= d6) {
    const t = (d4 - d3) / (d4 - d3 + d5 - d6)
    weights.set([0, 1 - t, t])
  } else weights.set([wa, wb, wc].map((weight) => weight / (wa + wb + wc)))
  let square = 0
  for (let k = 0; k < 3; k++)
    square += (weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k] - position[k]) ** 2
  return square
}

function minus(a: ArrayLike<number>, b: ArrayLike<number>): number[] {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

function dot3(a: readonly number[], b: readonly number[]): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
