import { type PixelBox, rasterize } from '../math/rasterize.ts'
import { uvToTexels } from '../math/triangle.ts'

/** Barycentric tolerance. It lets both triangles cover the texels on a shared edge, despite rounding. */
const TOLERANCE = 1e-6

/**
 * Visits the texels whose centres a triangle covers.
 *
 * @param uvs packed uv per vertex, v = 0 at the top. Outside 0..1, no texels are visited.
 * @param vertices indices of the triangle's vertices.
 * @param visit called with a texel's row-major index and the barycentric coordinates of its centre.
 */
export function coverTexels(
  uvs: ArrayLike<number>,
  vertices: readonly [a: number, b: number, c: number],
  width: number,
  height: number,
  visit: (texel: number, a: number, b: number, c: number) => void,
): void {
  const triangle = new Float64Array(6)
  uvToTexels(triangle, uvs, ...vertices, width, height)
  const map: PixelBox = [0, 0, width - 1, height - 1]
  rasterize(triangle, TOLERANCE, (column, row, a, b, c) => visit(row * width + column, a, b, c), map)
}
