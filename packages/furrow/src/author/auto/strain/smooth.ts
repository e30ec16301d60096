import type { SkinSurface } from '../../skin/surface.ts'
import { hasTensor, TENSOR_SIZE } from '../surface/tensors.ts'

/** Maximum fraction by which one iteration moves the tensor at a point towards the mean tensor of the neighbours. */
const MAX_STEP = 0.8
/** Maximum number of iterations. Meshes that would need more are smoothed less than requested. */
const MAX_ITERATIONS = 1000
/** Maximum number of neighbours that are read in all iterations together, to limit the time to a few seconds. */
const MAX_READS = 120_000_000
/**
 * If a surface is smoothed at most this often, each call may read `MAX_READS` neighbours. If it is smoothed more often, the total of all calls
 * is limited to `FREE_RUNS * MAX_READS`.
 */
const FREE_RUNS = 3
/** Maximum distance, in standard deviations, to which smoothing spreads a tensor. */
const SPREAD = 5

/**
 * Smooths the compression tensors of a skin by diffusion over the surface. The smoothing has the same width in millimetres for triangles of
 * any size.
 *
 * @param tensors `TENSOR_SIZE` components per point; changed in place.
 * @param sigma standard deviation of the smoothing, in the unit of the surface.
 * @param runs total number of calls for this surface. Many calls share a time limit.
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
  /** Tensors of `points`, followed by a zero tensor that represents all other points. */
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

/** Moves each point's tensor towards the mean of its neighbours. Unrolling the loop over components makes the function three times as fast. */
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

/** Distances between neighbouring points of a surface. */
interface Fineness {
  /** Mean squared distance from each point to its neighbours; 0 if a point has no neighbours. */
  squares: Float64Array
  /** First quartile of `squares`. */
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
  // Points without triangles do not count. They occur in files whose meshes share vertices.
  const sorted = squares.filter((square) => square > 0).sort()
  const fineness = { squares, fine: sorted[Math.floor(sorted.length / 4)] ?? 0 }
  known.set(surface, fineness)
  return fineness
}

/** Points of a surface that have a tensor or get one by smoothing. */
interface SmoothedPoints {
  /** Indices of the points in the surface. */
  points: Uint32Array
  /** Start of each point's neighbours in `neighbours`. */
  starts: Uint32Array
  /** Neighbours of each point, as indices into `points`. The index `points.length` represents all other points. */
  neighbours: Uint32Array
}

/** Returns the points that have tensors, and the points that are at most `rings` edges away from them. */
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
 * @param neighbours total number of neighbours of all points. A point has about six neighbours.
 * @param square mean squared distance between neighbours where the mesh is fine.
 */
export function iterationsOf(neighbours: number, square: number, sigma: number, runs = 1): number {
  // An iteration spreads tensors like a step of a random walk. With probability `MAX_STEP`, a step goes to a neighbour at the distance d. Each
  // step adds `MAX_STEP * d^2 / 2` to the variance along each axis. `square` is the mean of `d^2`.
  const wanted = Math.ceil((2 * sigma * sigma) / (MAX_STEP * Math.max(square, 1e-12)))
  const reads = MAX_READS * Math.min(1, FREE_RUNS / runs)
  return Math.min(wanted, MAX_ITERATIONS, Math.floor(reads / neighbours))
}

function squaredDistance(points: ArrayLike<number>, i: number, j: number): number {
  let sum = 0
  for (let k = 0; k < 3; k++) sum += (points[3 * i + k] - points[3 * j + k]) ** 2
  return sum
}
