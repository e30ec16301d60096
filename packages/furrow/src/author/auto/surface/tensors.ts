import { length3 } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface } from '../../skin/surface.ts'

/** Number of components of a symmetric 3 x 3 tensor: xx, xy, xz, yy, yz, zz. */
export const TENSOR_SIZE = 6

/**
 * Computes a tensor T for each point, which describes the shortening of the skin in each direction. For a unit vector c in the tangent plane,
 * `dot(c, T * c)` is the lost fraction of length.
 *
 * T is the mean over the triangles around a point, weighted by area. The tensor of a triangle is `I - U`, where U is the right stretch tensor
 * in the triangle's plane. This is the negative Biot strain (Bonet, Wood: Nonlinear Continuum Mechanics, 3.6).
 *
 * @param displacements packed xyz per point.
 * @returns `TENSOR_SIZE` components per point.
 */
export function compressionTensors(surface: SkinSurface, displacements: ArrayLike<number>): Float64Array {
  const { points, corners, areas } = surface
  const out = new Float64Array(TENSOR_SIZE * areas.length)
  const tensor = new Float64Array(TENSOR_SIZE)
  for (let t = 0; t < corners.length; t += 3) {
    if (!isMoved(displacements, corners, t)) continue
    const area = triangleTensor(points, displacements, corners[t], corners[t + 1], corners[t + 2], tensor)
    for (let k = 0; k < 3; k++) {
      const point = corners[t + k]
      const weight = area / (3 * areas[point])
      for (let j = 0; j < TENSOR_SIZE; j++) out[TENSOR_SIZE * point + j] += weight * tensor[j]
    }
  }
  return out
}

/** Maximum absolute value of components that count as 0. */
const NO_STRAIN = 1e-7

/** Returns whether the skin is strained at a point. */
export function hasTensor(tensors: Float64Array, point: number): boolean {
  for (let k = TENSOR_SIZE * point; k < TENSOR_SIZE * (point + 1); k++)
    if (Math.abs(tensors[k]) > NO_STRAIN) return true
  return false
}

function isMoved(displacements: ArrayLike<number>, corners: Uint32Array, first: number): boolean {
  for (let corner = first; corner < first + 3; corner++) {
    for (let i = 3 * corners[corner]; i < 3 * corners[corner] + 3; i++)
      if (displacements[i] !== 0) return true
  }
  return false
}

/** Computes the tensor of one triangle. Returns the triangle's area at rest. */
function triangleTensor(
  points: ArrayLike<number>,
  displacements: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): number {
  // Orthonormal frame (x, y) of the triangle's plane, in which its edges are (base, 0) and (offset, height).
  const ux = points[3 * b] - points[3 * a]
  const uy = points[3 * b + 1] - points[3 * a + 1]
  const uz = points[3 * b + 2] - points[3 * a + 2]
  const vx = points[3 * c] - points[3 * a]
  const vy = points[3 * c + 1] - points[3 * a + 1]
  const vz = points[3 * c + 2] - points[3 * a + 2]
  const base = length3(ux, uy, uz)
  const xx = ux / base
  const xy = uy / base
  const xz = uz / base
  const offset = vx * xx + vy * xy + vz * xz
  const height = length3(vx - offset * xx, vy - offset * xy, vz - offset * xz)
  const yx = (vx - offset * xx) / height
  const yy = (vy - offset * xy) / height
  const yz = (vz - offset * xz) / height
  // Right Cauchy-Green tensor `C = transpose(F) * F` with `F = [deformed u, deformed v] * inverse([base offset; 0 height])`.
  let c00 = 0
  let c01 = 0
  let c11 = 0
  for (let k = 0; k < 3; k++) {
    const [from, p, q] = [3 * a + k, 3 * b + k, 3 * c + k]
    const first = (points[p] - points[from] + displacements[p] - displacements[from]) / base
    const second =
      (points[q] - points[from] + displacements[q] - displacements[from] - offset * first) / height
    c00 += first * first
    c01 += first * second
    c11 += second * second
  }
  // Square root U of the 2 x 2 matrix C: `(C + sqrt(det(C)) * I) / sqrt(trace(C) + 2 * sqrt(det(C)))` (Levinger 1980).
  const root = Math.sqrt(Math.max(0, c00 * c11 - c01 * c01))
  const scale = Math.sqrt(c00 + c11 + 2 * root)
  const s00 = scale > 0 ? 1 - (c00 + root) / scale : 1
  const s01 = scale > 0 ? -c01 / scale : 0
  const s11 = scale > 0 ? 1 - (c11 + root) / scale : 1
  out[0] = s00 * xx * xx + 2 * s01 * xx * yx + s11 * yx * yx
  out[1] = s00 * xx * xy + s01 * (xx * yy + xy * yx) + s11 * yx * yy
  out[2] = s00 * xx * xz + s01 * (xx * yz + xz * yx) + s11 * yx * yz
  out[3] = s00 * xy * xy + 2 * s01 * xy * yy + s11 * yy * yy
  out[4] = s00 * xy * xz + s01 * (xy * yz + xz * yy) + s11 * yy * yz
  out[5] = s00 * xz * xz + 2 * s01 * xz * yz + s11 * yz * yz
  return (base * height) / 2
}

const interpolated = new Float64Array(TENSOR_SIZE)

/** Interpolates the tensor at barycentric coordinates of a triangle. The next call overwrites the returned array. */
export function tensorAt(
  surface: SkinSurface,
  tensors: Float64Array,
  triangle: number,
  barycentrics: ArrayLike<number>,
): Float64Array {
  interpolated.fill(0)
  for (const [corner, point] of cornersOf(surface, triangle).entries()) {
    for (let k = 0; k < TENSOR_SIZE; k++)
      interpolated[k] += barycentrics[corner] * tensors[TENSOR_SIZE * point + k]
  }
  return interpolated
}

/** Returns `dot(c, T * c)` for the unit vector c = (x, y, z): the fraction by which skin is shortened in this direction. */
export function compressionAlong(t: ArrayLike<number>, x: number, y: number, z: number): number {
  return t[0] * x * x + t[3] * y * y + t[5] * z * z + 2 * (t[1] * x * y + t[2] * x * z + t[4] * y * z)
}

/** Returns `dot(v, T * w)`. */
export function bilinearForm(t: ArrayLike<number>, v: ArrayLike<number>, w: ArrayLike<number>): number {
  return (
    v[0] * (t[0] * w[0] + t[1] * w[1] + t[2] * w[2]) +
    v[1] * (t[1] * w[0] + t[3] * w[1] + t[4] * w[2]) +
    v[2] * (t[2] * w[0] + t[4] * w[1] + t[5] * w[2])
  )
}
