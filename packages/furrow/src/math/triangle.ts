/**
 * Computes the cross product of a triangle's edges: an unnormalised normal, twice as long as the area.
 *
 * @param positions x, y and z of each vertex.
 * @param a, b, c the triangle's vertices, counterclockwise as seen from outside.
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
 * Computes the area of a triangle in the texture, as a fraction of the texture.
 *
 * @param uvs u and v of each vertex.
 * @param a, b, c the triangle's vertices.
 */
export function uvArea(uvs: ArrayLike<number>, a: number, b: number, c: number): number {
  const ux = uvs[2 * b] - uvs[2 * a]
  const uy = uvs[2 * b + 1] - uvs[2 * a + 1]
  const vx = uvs[2 * c] - uvs[2 * a]
  const vy = uvs[2 * c + 1] - uvs[2 * a + 1]
  return Math.abs(ux * vy - uy * vx) / 2
}

/**
 * Converts the texture coordinates of a triangle to x and y in texels; texel centres are at integers.
 *
 * @param out receives six numbers.
 * @param uvs u and v of each vertex.
 * @param a, b, c the triangle's vertices.
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
