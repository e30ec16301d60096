import type { SkinSurface } from '../../skin/surface.ts'

/** Fraction of the way to its neighbours' mean that a point moves in one iteration, at most. */
const MAX_STEP = 0.8
/**
 * Iterations at most, and neighbours times iterations at most, some seconds: meshes much finer than skin creases are smoothed less than
 * asked for. The second keeps the time linear in the size of the mesh, which is larger just where more iterations are needed.
 */
const MAX_ITERATIONS = 1000
const MAX_READS = 240_000_000
/** Runs that may each take the whole of it; more have less each. */
const FREE_RUNS = 10

/**
 * Smooths values at points by diffusion over the surface: whatever the size of the triangles, an impulse spreads as wide as asked for.
 *
 * @param values `stride` numbers per point; changed.
 * @param sigma standard deviation of the spread impulse, in the surface's unit.
 * @param runs how often the surface is smoothed in all: as a whole they take no longer than a few.
 */
export function smooth(
  surface: SkinSurface,
  values: Float64Array,
  stride: number,
  sigma: number,
  runs = 1,
): void {
  const { points, neighbourStarts: starts, neighbours, areas } = surface
  const count = areas.length
  /** Mean squared distance from each point to its neighbours. */
  const squares = new Float64Array(count)
  for (let i = 0; i < count; i++) {
    for (let n = starts[i]; n < starts[i + 1]; n++) squares[i] += squaredDistance(points, i, neighbours[n])
    squares[i] /= Math.max(1, starts[i + 1] - starts[i])
  }
  // Points without triangles, as in files whose meshes share vertices, say nothing about how fine this mesh is.
  const sorted = squares.filter((square) => square > 0).sort()
  const fine = sorted[Math.floor(sorted.length / 4)] ?? 0
  const iterations = iterationsOf(neighbours.length, fine, sigma, runs)
  const before = new Float64Array(values.length)
  for (let iteration = 0; iteration < iterations; iteration++) {
    before.set(values)
    for (let i = 0; i < count; i++) {
      const valence = starts[i + 1] - starts[i]
      if (valence === 0) continue
      const step = Math.min(MAX_STEP, (2 * sigma * sigma) / (iterations * Math.max(squares[i], 1e-12)))
      for (let k = 0; k < stride; k++) {
        let sum = 0
        for (let n = starts[i]; n < starts[i + 1]; n++) sum += before[stride * neighbours[n] + k]
        values[stride * i + k] += step * (sum / valence - before[stride * i + k])
      }
    }
  }
}

/**
 * How often points are moved towards their neighbours.
 *
 * @param neighbours of all points, about six each.
 * @param square mean squared distance of neighbours where the mesh is fine.
 */
export function iterationsOf(neighbours: number, square: number, sigma: number, runs = 1): number {
  // A step of length d in a random direction, taken with probability p, adds p d^2 / 2 to the variance along each axis.
  const wanted = Math.ceil((2 * sigma * sigma) / (MAX_STEP * Math.max(square, 1e-12)))
  const reads = MAX_READS * Math.min(1, FREE_RUNS / runs)
  return Math.min(wanted, MAX_ITERATIONS, Math.ceil(reads / neighbours))
}

function squaredDistance(points: ArrayLike<number>, i: number, j: number): number {
  let sum = 0
  for (let k = 0; k < 3; k++) sum += (points[3 * i + k] - points[3 * j + k]) ** 2
  return sum
}
