import { type PixelBox, rasterize } from '../math/rasterize.ts'
import { uvToTexels } from '../math/triangle.ts'

/** Lets triangles that share an edge both cover the texels on it, in spite of rounding. */
const TOLERANCE = 1e-6

/**
 * Visits the texels of a map whose centres a triangle covers.
 *
 * @param uvs u and v of each vertex, v = 0 at the top. Nothing outside 0..1 is visited.
 * @param vertices of the triangle.
 * @param visit is given the texel's index, row by row, and its barycentric coordinates.
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
