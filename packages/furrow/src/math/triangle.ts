/**
 * Computes the normal of a triangle as the cross product of two edges. The length of the normal is twice the area of the triangle.
 *
 * @param positions packed xyz per vertex.
 * @param a, b, c vertex indices of the triangle, counterclockwise as seen from outside.
 */
export function triangleNormal(
  out: Float64Array,
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
): void {
  const ux = positions[3 * b] - positions[3 * a]
  const uy = positions[3 * b + 1] - positions[3 * a + 1]
  const uz = positions[3 * b + 2] - positions[3 * a + 2]
  const vx = positions[3 * c] - positions[3 * a]
  const vy = positions[3 * c + 1] - positions[3 * a + 1]
  const vz = positions[3 * c + 2] - positions[3 * a + 2]
  out[0] = uy * vz - uz * vy
  out[1] = uz * vx - ux * vz
  out[2] = ux * vy - uy * vx
}

/**
 * Computes the area of a triangle in texture coordinates. The full texture has an area of 1.
 *
 * @param uvs packed uv per vertex.
 * @param a, b, c vertex indices of the triangle.
 */
export function uvArea(uvs: ArrayLike<number>, a: number, b: number, c: number): number {
  const ux = uvs[2 * b] - uvs[2 * a]
  const uy = uvs[2 * b + 1] - uvs[2 * a + 1]
  const vx = uvs[2 * c] - uvs[2 * a]
  const vy = uvs[2 * c + 1] - uvs[2 * a + 1]
  return Math.abs(ux * vy - uy * vx) / 2
}

/**
 * Converts the corners of a triangle from texture coordinates to texels. Texel centres are at integers.
 *
 * @param out receives x and y of the three corners.
 * @param uvs packed uv per vertex.
 * @param a, b, c vertex indices of the triangle.
 */
export function uvToTexels(
  out: Float64Array,
  uvs: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  width: number,
  height: number,
): void {
  out[0] = uvs[2 * a] * width - 0.5
  out[1] = uvs[2 * a + 1] * height - 0.5
  out[2] = uvs[2 * b] * width - 0.5
  out[3] = uvs[2 * b + 1] * height - 0.5
  out[4] = uvs[2 * c] * width - 0.5
  out[5] = uvs[2 * c + 1] * height - 0.5
}
