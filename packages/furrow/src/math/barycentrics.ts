/**
 * Computes the barycentric coordinates of a point in 2D. If the point is outside the triangle, at least one coordinate is negative. If the
 * triangle has no area, the coordinates are infinite or NaN.
 *
 * @param out receives three coordinates.
 * @param triangle x and y of the three corners.
 */
export function barycentrics2(out: Float64Array, triangle: ArrayLike<number>, x: number, y: number): void {
  const ux = triangle[2] - triangle[0]
  const uy = triangle[3] - triangle[1]
  const vx = triangle[4] - triangle[0]
  const vy = triangle[5] - triangle[1]
  const px = x - triangle[0]
  const py = y - triangle[1]
  const det = ux * vy - uy * vx
  out[1] = (px * vy - py * vx) / det
  out[2] = (ux * py - uy * px) / det
  out[0] = 1 - out[1] - out[2]
}

/**
 * Projects a point onto the plane of a triangle, and computes its barycentric coordinates (Ericson, Real-Time Collision Detection, 3.4). If
 * the triangle has no area, the coordinates are infinite or NaN.
 *
 * @param positions packed xyz per vertex.
 * @param a, b, c vertex indices of the triangle.
 * @param point x, y and z of the point.
 */
export function barycentrics3(
  out: Float64Array,
  positions: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  point: ArrayLike<number>,
): void {
  let uu = 0
  let uv = 0
  let vv = 0
  let pu = 0
  let pv = 0
  for (let k = 0; k < 3; k++) {
    const u = positions[3 * b + k] - positions[3 * a + k]
    const v = positions[3 * c + k] - positions[3 * a + k]
    const p = point[k] - positions[3 * a + k]
    uu += u * u
    uv += u * v
    vv += v * v
    pu += p * u
    pv += p * v
  }
  const det = uu * vv - uv * uv
  out[1] = (vv * pu - uv * pv) / det
  out[2] = (uu * pv - uv * pu) / det
  out[0] = 1 - out[1] - out[2]
}

/**
 * Interpolates a vertex attribute at a point of a triangle. Interpolated vectors are not normalised.
 *
 * @param out receives the interpolated attribute. The length of `out` is the number of components.
 * @param values `stride` numbers per vertex.
 * @param a, b, c vertex indices of the triangle.
 * @param wa, wb, wc barycentric coordinates of the point.
 */
export function interpolate(
  out: Float64Array,
  values: ArrayLike<number>,
  stride: number,
  a: number,
  b: number,
  c: number,
  wa: number,
  wb: number,
  wc: number,
): void {
  for (let k = 0; k < out.length; k++) {
    out[k] = wa * values[stride * a + k] + wb * values[stride * b + k] + wc * values[stride * c + k]
  }
}
