import type { SkinSurface } from '../../skin/surface.ts'
import { hasTensor, TENSOR_SIZE } from './tensors.ts'

/** Maximum fraction of the way to its neighbours' mean that a point moves per iteration. */
const MAX_STEP = 0.8
/**
 * Maximum numbers of iterations, and of neighbours times iterations (a few seconds). Meshes much finer than skin creases are smoothed less
 * than requested. The second limit keeps the time linear in the mesh size, which is largest where most iterations are needed.
 */
const MAX_ITERATIONS = 1000
const MAX_READS = 120_000_000
/** Number of runs that may each use the full limit; more runs share it. */
const FREE_RUNS = 3
/** Distance in standard deviations beyond which an impulse vanishes. */
const SPREAD = 5

/**
 * Smooths tensors at points by diffusion over the surface. An impulse spreads by the same width for any triangle size.
 *
 * @param tensors `TENSOR_SIZE` components per point; changed in place.
 * @param sigma standard deviation of the spread impulse, in the surface's unit.
 * @param runs total number of runs on this surface, which share a time limit.
 */
export function smooth(surface: SkinSurface, tensors: Float64Array, sigma: number, runs = 1): void {
  const { squares, fine } = finenessOf(surface)
  const rings = Math.ceil((SPREAD * sigma) / Math.sqrt(Math.max(fine, 1e-12)))
  const around = pointsAround(surface, tensors, rings)
  const { points } = around
  const iterations = iterationsOf(around.neighbours.length, fine, sigma, runs)
  const steps = Float64Array.from(points, (point) =>
    Math.min(MAX_STEP, (2 * sigma * sigma) / (iterations * Math.max(squares[point], 1e-12))),
  )
  /** Tensors of these points, and of one that represents all others. */
  let before = new Float64Array(TENSOR_SIZE * (points.length + 1))
  let after = new Float64Array(before.length)
  for (let i = 0; i < points.length; i++)
    for (let k = 0; k < TENSOR_SIZE; k++) before[TENSOR_SIZE * i + k] = tensors[TENSOR_SIZE * points[i] + k]
  for (let iteration = 0; iteration < iterations; iteration++) {
    diffuse(around, steps, before, after)
    ;[before, after] = [after, before]
  }
  for (let i = 0; i < points.length; i++)
    for (let k = 0; k < TENSOR_SIZE; k++) tensors[TENSOR_SIZE * points[i] + k] = before[TENSOR_SIZE * i + k]
}

/** Moves each point's tensor towards the mean of its neighbours. Unrolled components are three times as fast. */
function diffuse(
  { starts, neighbours }: Pick<SmoothedPoints, 'starts' | 'neighbours'>,
  steps: Float64Array,
  before: Float64Array,
  after: Float64Array,
): void {
  for (let i = 0; i < steps.length; i++) {
    let xx = 0
    let xy = 0
    let xz = 0
    let yy = 0
    let yz = 0
    let zz = 0
    for (let n = starts[i]; n < starts[i + 1]; n++) {
      const k = TENSOR_SIZE * neighbours[n]
      xx += before[k]
      xy += before[k + 1]
      xz += before[k + 2]
      yy += before[k + 3]
      yz += before[k + 4]
      zz += before[k + 5]
    }
    const valence = starts[i + 1] - starts[i]
    const step = steps[i]
    const k = TENSOR_SIZE * i
    after[k] = before[k] + step * (xx / valence - before[k])
    after[k + 1] = before[k + 1] + step * (xy / valence - before[k + 1])
    after[k + 2] = before[k + 2] + step * (xz / valence - before[k + 2])
    after[k + 3] = before[k + 3] + step * (yy / valence - before[k + 3])
    after[k + 4] = before[k + 4] + step * (yz / valence - before[k + 4])
    after[k + 5] = before[k + 5] + step * (zz / valence - before[k + 5])
  }
}

interface Fineness {
  /** Mean squared distance from each point to its neighbours; 0 without neighbours. */
  squares: Float64Array
  /** Squared distance at the finest quartile. */
  fine: number
}

const known = new WeakMap<SkinSurface, Fineness>()

function finenessOf(surface: SkinSurface): Fineness {
  const { points, neighbourStarts: starts, neighbours } = surface
  const before = known.get(surface)
  if (before) return before
  const squares = new Float64Array(points.length / 3)
  for (let i = 0; i < squares.length; i++) {
    for (let n = starts[i]; n < starts[i + 1]; n++) squares[i] += squaredDistance(points, i, neighbours[n])
    squares[i] /= Math.max(1, starts[i + 1] - starts[i])
  }
  // Points without triangles, as in files whose meshes share vertices, do not count.
  const sorted = squares.filter((square) => square > 0).sort()
  const fineness = { squares, fine: sorted[Math.floor(sorted.length / 4)] ?? 0 }
  known.set(surface, fineness)
  return fineness
}

/** Points of a surface that have or may get a tensor. */
interface SmoothedPoints {
  /** Indices of the points in the surface. */
  points: Uint32Array
  /** Neighbours of each point, as indices into `points`; `points.length` represents any other point. */
  starts: Uint32Array
  neighbours: Uint32Array
}

/** Returns the points with tensors, and points up to `rings` edges away. */
function pointsAround(surface: SkinSurface, tensors: Float64Array, rings: number): SmoothedPoints {
  const { neighbourStarts, neighbours } = surface
  const isInside = new Uint8Array(neighbourStarts.length - 1)
  let ring: number[] = []
  for (let i = 0; i < isInside.length; i++) {
    if (!hasTensor(tensors, i)) continue
    isInside[i] = 1
    ring.push(i)
  }
  for (let k = 0; k < rings && ring.length > 0; k++) {
    const next: number[] = []
    for (const point of ring) {
      for (let n = neighbourStarts[point]; n < neighbourStarts[point + 1]; n++) {
        if (isInside[neighbours[n]]) continue
        isInside[neighbours[n]] = 1
        next.push(neighbours[n])
      }
    }
    ring = next
  }
  const valenceOf = (point: number) => neighbourStarts[point + 1] - neighbourStarts[point]
  const all = new Uint32Array(isInside.length)
  let count = 0
  for (let i = 0; i < isInside.length; i++) if (isInside[i] === 1 && valenceOf(i) > 0) all[count++] = i
  const points = all.slice(0, count)
  const indexOf = new Uint32Array(isInside.length).fill(count)
  const starts = new Uint32Array(count + 1)
  for (let i = 0; i < count; i++) {
    indexOf[points[i]] = i
    starts[i + 1] = starts[i] + valenceOf(points[i])
  }
  const within = new Uint32Array(starts[points.length])
  for (let i = 0, n = 0; i < points.length; i++) {
    const end = neighbourStarts[points[i] + 1]
    for (let from = neighbourStarts[points[i]]; from < end; from++) within[n++] = indexOf[neighbours[from]]
  }
  return { points, starts, neighbours: within }
}

/**
 * Returns the number of smoothing iterations.
 *
 * @param neighbours total number of neighbours of all points, about six each.
 * @param square mean squared distance of neighbours where the mesh is fine.
 */
export function iterationsOf(neighbours: number, square: number, sigma: number, runs = 1): number {
  // A step of length d in a random direction, taken with probability p, adds p d^2 / 2 to the variance along each axis.
  const wanted = Math.ceil((2 * sigma * sigma) / (MAX_STEP * Math.max(square, 1e-12)))
  const reads = MAX_READS * Math.min(1, FREE_RUNS / runs)
  return Math.min(wanted, MAX_ITERATIONS, Math.floor(reads / neighbours))
}

function squaredDistance(points: ArrayLike<number>, i: number, j: number): number {
  let sum = 0
  for (let k = 0; k < 3; k++) sum += (points[3 * i + k] - points[3 * j + k]) ** 2
  return sum
}
