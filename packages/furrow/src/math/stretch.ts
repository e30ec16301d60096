/** Scratch array with dot products of two edges u and v of a triangle: `dot(u, u)`, `dot(u, v)` and `dot(v, v)`. */
const products = new Float64Array(3)

/**
 * Inverts the 2 x 2 matrix of a triangle in its rest pose. The columns of the matrix are two edges, in 2D coordinates of the triangle's plane.
 * `principalStretches` needs the inverse.
 *
 * @param a, b, c vertex indices of the triangle.
 * @param positions packed xyz per vertex, in the rest pose.
 * @returns elements xx, xy and yy of the inverse. The element yx is 0. Undefined if the triangle has no area.
 */
export function restInverse(
  a: number,
  b: number,
  c: number,
  positions: ArrayLike<number>,
): number[] | undefined {
  multiplyEdges(a, b, c, positions)
  const [uu, uv, vv] = products
  // In 2D coordinates of the triangle's plane, the first edge is (along, 0) and the second edge is (across, height).
  const along = Math.sqrt(uu)
  const across = uv / along
  const height = Math.sqrt(Math.max(0, vv - across * across))
  const inverse = [1 / along, -across / (along * height), 1 / height]
  return inverse.every(Number.isFinite) ? inverse : undefined
}

/** Mesh in its rest pose, and optionally a direction along which stretch is measured. */
export interface AtRest {
  /** Packed xyz per vertex. */
  positions: ArrayLike<number>
  /** Packed uv per vertex. Only needed with `direction`. */
  uvs: ArrayLike<number>
  /** Vector in texture coordinates, of any length except 0. Without it, stretch is measured along the principal directions. */
  direction?: readonly [number, number] | undefined
}

/**
 * Returns the numbers that `principalStretches` needs for a triangle. Without a direction, they are the result of `restInverse`. With a
 * direction, both results of `principalStretches` will be the stretch along this direction.
 *
 * @param a, b, c vertex indices of the triangle.
 * @returns three numbers. With a direction, these are 0, a factor for the edge from `a` to `b`, and a factor for the edge from `a` to `c`. The
 *   edges times their factors add up to a unit vector in the direction. Undefined if the triangle has no area. With a direction, the triangle
 *   must also have an area in the texture.
 */
export function restMatrix(
  a: number,
  b: number,
  c: number,
  { positions, uvs, direction }: AtRest,
): number[] | undefined {
  const inverse = restInverse(a, b, c, positions)
  if (!inverse || !direction) return inverse
  const [du, dv] = direction
  const [u1, v1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]]
  const [u2, v2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]]
  const [first, second] = [du * v2 - dv * u2, dv * u1 - du * v1]
  multiplyEdges(a, b, c, positions)
  const [uu, uv, vv] = products
  const length = Math.sqrt(first * first * uu + 2 * first * second * uv + second * second * vv)
  const isMapped = u1 * v2 - v1 * u2 !== 0
  const matrix = [0, first / length, second / length]
  return isMapped && matrix.every(Number.isFinite) ? matrix : undefined
}

/**
 * Computes the two principal stretches of a triangle in its plane. A stretch is the current length divided by the length at rest. Principal
 * stretches are the square roots of the eigenvalues of the right Cauchy-Green tensor (Bonet, Wood: Nonlinear Continuum Mechanics, 3.6).
 *
 * @param out receives the smaller and then the larger stretch.
 * @param inverses results of `restInverse` or `restMatrix`, three numbers per triangle.
 * @param offset index of the triangle's first number in `inverses`.
 * @param a, b, c vertex indices of the triangle.
 * @param positions packed xyz per vertex, in the current pose.
 */
export function principalStretches(
  out: Float64Array,
  inverses: ArrayLike<number>,
  offset: number,
  a: number,
  b: number,
  c: number,
  positions: ArrayLike<number>,
): void {
  multiplyEdges(a, b, c, positions)
  const uu = products[0]
  const uv = products[1]
  const vv = products[2]
  const xx = inverses[offset]
  const xy = inverses[offset + 1]
  const yy = inverses[offset + 2]
  const c00 = xx * xx * uu
  const c01 = xx * (xy * uu + yy * uv)
  const c11 = xy * xy * uu + 2 * xy * yy * uv + yy * yy * vv
  const mean = (c00 + c11) / 2
  const spread = Math.sqrt(((c00 - c11) / 2) ** 2 + c01 * c01)
  out[1] = Math.sqrt(mean + spread)
  // `xx` is 0 only if `restMatrix` was called with a direction.
  out[0] = xx === 0 ? out[1] : Math.sqrt(Math.max(0, mean - spread))
}

function multiplyEdges(a: number, b: number, c: number, positions: ArrayLike<number>): void {
  let uu = 0
  let uv = 0
  let vv = 0
  for (let axis = 0; axis < 3; axis++) {
    const u = positions[3 * b + axis] - positions[3 * a + axis]
    const v = positions[3 * c + axis] - positions[3 * a + axis]
    uu += u * u
    uv += u * v
    vv += v * v
  }
  products[0] = uu
  products[1] = uv
  products[2] = vv
}
