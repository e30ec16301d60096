import type { Surface } from './surface.ts'

/** Numbers of a symmetric tensor of three dimensions: xx, xy, xz, yy, yz, zz. */
export const TENSOR = 6
/** Millimetres over which the strain of a pose is evened, unless told: that of one triangle says little. */
const EVEN = 3
/** Share of the way to its neighbours' mean that a point goes in one round of smoothing, at most. */
const LARGEST_STEP = 0.8
/** Rounds of smoothing, at most: meshes far finer than skin creases are smoothed less than asked for. */
const MOST_ROUNDS = 1000

/**
 * What a pose does to the skin, as `compressionTensors`, smoothed.
 *
 * @param offsets x, y and z that each target adds to each point, in millimetres.
 * @param pose weights by target.
 * @param even millimetres over which it is evened.
 */
export function strainOf(
  surface: Surface,
  offsets: readonly Float64Array[],
  pose: ReadonlyMap<number, number>,
  even = EVEN,
): Float64Array {
  const moved = new Float64Array(surface.points.length)
  for (const [target, weight] of pose) {
    for (let i = 0; i < moved.length; i++) moved[i]! += weight * offsets[target]![i]!
  }
  const tensors = compressionTensors(surface, moved)
  smooth(surface, tensors, TENSOR, even)
  return tensors
}

/**
 * How far skin is shortened at each point, and in which direction: I - U, where U is the right stretch tensor of each triangle in its own
 * plane (Biot's strain with the sign of compression; Bonet, Wood: Nonlinear Continuum Mechanics, 3.6), as the mean of the triangles round a
 * point by their areas. Along a direction c of the skin, c . T c is the share of its length that is lost.
 *
 * @param offsets x, y and z by which each point moves.
 * @returns six numbers for each point.
 */
export function compressionTensors(surface: Surface, offsets: ArrayLike<number>): Float64Array {
  const { points, corners, areas } = surface
  const out = new Float64Array(TENSOR * areas.length)
  const frame = new Float64Array(TENSOR)
  for (let t = 0; t < corners.length; t += 3) {
    const area = triangleTensor(points, offsets, corners[t]!, corners[t + 1]!, corners[t + 2]!, frame)
    for (let k = 0; k < 3; k++) {
      const i = corners[t + k]!
      const share = area / (3 * areas[i]!)
      for (let j = 0; j < TENSOR; j++) out[TENSOR * i + j]! += share * frame[j]!
    }
  }
  return out
}

/** The tensor of one triangle; returns its area at rest. */
function triangleTensor(
  points: ArrayLike<number>,
  offsets: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): number {
  const edge = (from: number, to: number, k: number) => points[3 * to + k]! - points[3 * from + k]!
  const moved = (from: number, to: number, k: number) =>
    edge(from, to, k) + offsets[3 * to + k]! - offsets[3 * from + k]!
  const [ux, uy, uz] = [edge(a, b, 0), edge(a, b, 1), edge(a, b, 2)]
  const [vx, vy, vz] = [edge(a, c, 0), edge(a, c, 1), edge(a, c, 2)]
  const along = Math.hypot(ux, uy, uz)
  const [xx, xy, xz] = [ux / along, uy / along, uz / along]
  const across = vx * xx + vy * xy + vz * xz
  const [wx, wy, wz] = [vx - across * xx, vy - across * xy, vz - across * xz]
  const height = Math.hypot(wx, wy, wz)
  const [yx, yy, yz] = [wx / height, wy / height, wz / height]
  // F = [moved u, moved v] [along across; 0 height]^-1
  const gradient = [0, 1, 2].map((k) => {
    const first = moved(a, b, k) / along
    return [first, (moved(a, c, k) - across * first) / height]
  })
  let [c00, c01, c11] = [0, 0, 0]
  for (const [first, second] of gradient as [number, number][]) {
    c00 += first * first
    c01 += first * second
    c11 += second * second
  }
  // The root of a 2 x 2 matrix: (C + sqrt(det) I) / sqrt(trace + 2 sqrt(det)) (Levinger 1980).
  const root = Math.sqrt(Math.max(0, c00 * c11 - c01 * c01))
  const scale = Math.sqrt(c00 + c11 + 2 * root)
  const [s00, s01, s11] =
    scale > 0 ? [1 - (c00 + root) / scale, -c01 / scale, 1 - (c11 + root) / scale] : [1, 0, 1]
  out[0] = s00 * xx * xx + 2 * s01 * xx * yx + s11 * yx * yx
  out[1] = s00 * xx * xy + s01 * (xx * yy + xy * yx) + s11 * yx * yy
  out[2] = s00 * xx * xz + s01 * (xx * yz + xz * yx) + s11 * yx * yz
  out[3] = s00 * xy * xy + 2 * s01 * xy * yy + s11 * yy * yy
  out[4] = s00 * xy * xz + s01 * (xy * yz + xz * yy) + s11 * yy * yz
  out[5] = s00 * xz * xz + 2 * s01 * xz * yz + s11 * yz * yz
  return (along * height) / 2
}

/** c . T c: the share by which skin is shortened along a direction. */
export function along(tensors: ArrayLike<number>, at: number, x: number, y: number, z: number): number {
  const t = (k: number) => tensors[at + k]!
  return t(0) * x * x + t(3) * y * y + t(5) * z * z + 2 * (t(1) * x * y + t(2) * x * z + t(4) * y * z)
}

/**
 * Smooths what is known at points, by diffusion over the surface: however wide the triangles are, a spot becomes as wide as asked for.
 *
 * @param values `size` numbers for each point; changed.
 * @param sigma standard deviation of the spot, in the surface's unit.
 */
export function smooth(surface: Surface, values: Float64Array, size: number, sigma: number): void {
  const { points, starts, neighbours, areas } = surface
  const count = areas.length
  const squares = new Float64Array(count)
  for (let i = 0; i < count; i++) {
    for (let n = starts[i]!; n < starts[i + 1]!; n++)
      squares[i]! += distanceSquared(points, i, neighbours[n]!)
    squares[i]! /= Math.max(1, starts[i + 1]! - starts[i]!)
  }
  // Points of no triangle, as files have them that share vertices among meshes, say nothing of how fine this one is.
  const known = squares.filter((square) => square > 0).sort()
  const fine = known[Math.floor(known.length / 4)] ?? 0
  // A step of length d in a random direction, taken with probability p, adds p d^2 / 2 to the variance along each axis.
  const asked = Math.ceil((2 * sigma * sigma) / (LARGEST_STEP * Math.max(fine, 1e-12)))
  const rounds = Math.min(asked, MOST_ROUNDS)
  const before = new Float64Array(values.length)
  for (let round = 0; round < rounds; round++) {
    before.set(values)
    for (let i = 0; i < count; i++) {
      const total = starts[i + 1]! - starts[i]!
      if (total === 0) continue
      const share = Math.min(LARGEST_STEP, (2 * sigma * sigma) / (rounds * Math.max(squares[i]!, 1e-12)))
      for (let k = 0; k < size; k++) {
        let sum = 0
        for (let n = starts[i]!; n < starts[i + 1]!; n++) sum += before[size * neighbours[n]! + k]!
        values[size * i + k]! += share * (sum / total - before[size * i + k]!)
      }
    }
  }
}

function distanceSquared(points: ArrayLike<number>, i: number, j: number): number {
  let sum = 0
  for (let k = 0; k < 3; k++) sum += (points[3 * i + k]! - points[3 * j + k]!) ** 2
  return sum
}
