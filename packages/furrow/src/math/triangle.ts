/**
 * Surface of a triangle in the texture, 1 for the whole of it.
 *
 * @param uvs u and v of each vertex.
 * @param a, b, c its vertices.
 */
export function uvArea(uvs: ArrayLike<number>, a: number, b: number, c: number): number {
  const ux = uvs[2 * b]! - uvs[2 * a]!
  const uy = uvs[2 * b + 1]! - uvs[2 * a + 1]!
  const vx = uvs[2 * c]! - uvs[2 * a]!
  const vy = uvs[2 * c + 1]! - uvs[2 * a + 1]!
  return Math.abs(ux * vy - uy * vx) / 2
}
