import { atan2, cos, sin } from '../../../math/elementary.ts'
import { triangleNormal } from '../../../math/triangle.ts'
import { cross, length2, normalize } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface } from '../../skin/surface.ts'
import { bilinearForm, compressionAlong, TENSOR_SIZE, tensorAt } from '../surface/tensors.ts'

/** Largest compression of skin at a point, among all directions in the plane of the skin. */
export interface PrincipalCompression {
  /** Unit vector along the creases: perpendicular to the direction of largest compression. */
  direction: Float64Array
  /** Fraction of length that the skin loses perpendicular to `direction`. */
  compression: number
}

/** Computes the principal compression at a position in a triangle, given by barycentric coordinates. */
export function principalAt(
  surface: SkinSurface,
  tensors: Float64Array,
  triangle: number,
  barycentrics: ArrayLike<number>,
): PrincipalCompression {
  const { points } = surface
  const [a, b, c] = cornersOf(surface, triangle)
  const [normal, x, y] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  triangleNormal(normal, points, a, b, c)
  normalize(normal)
  for (let k = 0; k < 3; k++) x[k] = points[3 * b + k] - points[3 * a + k]
  normalize(x)
  cross(y, normal, x)
  const { compression, angle } = largestInPlane(tensorAt(surface, tensors, triangle, barycentrics), x, y)
  const [cosine, sine] = [cos(angle), sin(angle)]
  const direction = y.map((value, k) => cosine * value - sine * x[k])
  return { direction, compression }
}

const [pointX, pointY] = [new Float64Array(3), new Float64Array(3)]

/** Returns the fraction of length that skin loses at a point in the direction of largest loss. */
export function pointCompression({ normals }: SkinSurface, tensors: Float64Array, point: number): number {
  const normal = normals.subarray(3 * point, 3 * point + 3)
  cross(pointX, normal, Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0])
  normalize(pointX)
  cross(pointY, normal, pointX)
  const tensor = tensors.subarray(TENSOR_SIZE * point, TENSOR_SIZE * (point + 1))
  return largestInPlane(tensor, pointX, pointY).compression
}

/**
 * Returns the largest eigenvalue of a tensor restricted to a plane (Mohr's circle), and the angle of the eigenvector, from x towards y.
 *
 * @param x, y orthonormal vectors that span the plane.
 */
function largestInPlane(
  t: ArrayLike<number>,
  x: Float64Array,
  y: Float64Array,
): { compression: number; angle: number } {
  const xx = compressionAlong(t, x[0], x[1], x[2])
  const xy = bilinearForm(t, x, y)
  const yy = compressionAlong(t, y[0], y[1], y[2])
  return {
    compression: (xx + yy) / 2 + length2((xx - yy) / 2, xy),
    angle: 0.5 * atan2(2 * xy, xx - yy),
  }
}
