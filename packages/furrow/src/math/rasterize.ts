/** Box of pixels. The columns `left` and `right` and the rows `top` and `bottom` are inside the box. */
export type PixelBox = readonly [left: number, top: number, right: number, bottom: number]

const UNBOUNDED: PixelBox = [-Infinity, -Infinity, Infinity, Infinity]

/** A triangle covers no pixel if twice its area, in square pixels, is below this number. */
const NO_AREA = 1e-9

/**
 * Visits the pixels whose centres a triangle covers, row by row. If a centre lies on an edge, both triangles at the edge cover it.
 *
 * @param triangle x and y of the three corners in pixels. Pixel centres are at integers.
 * @param tolerance amount by which barycentric coordinates may be below 0.
 * @param visit receives the column and row of a pixel, and the barycentric coordinates of its centre.
 * @param box limits the visited pixels.
 */
export function rasterize(
  triangle: ArrayLike<number>,
  tolerance: number,
  visit: (column: number, row: number, a: number, b: number, c: number) => void,
  [left, top, right, bottom]: PixelBox = UNBOUNDED,
): void {
  const x0 = triangle[0]
  const y0 = triangle[1]
  const x1 = triangle[2]
  const y1 = triangle[3]
  const x2 = triangle[4]
  const y2 = triangle[5]
  const ux = x1 - x0
  const uy = y1 - y0
  const vx = x2 - x0
  const vy = y2 - y0
  const det = ux * vy - uy * vx
  if (Math.abs(det) < NO_AREA) return
  const firstRow = Math.max(Math.ceil(Math.min(y0, y1, y2)), top)
  const lastRow = Math.min(Math.floor(Math.max(y0, y1, y2)), bottom)
  const firstColumn = Math.max(Math.ceil(Math.min(x0, x1, x2)), left)
  const lastColumn = Math.min(Math.floor(Math.max(x0, x1, x2)), right)
  for (let row = firstRow; row <= lastRow; row++) {
    for (let column = firstColumn; column <= lastColumn; column++) {
      // Formulas of `barycentrics2`, written inline because a call of that function takes three times as long.
      const b = ((column - x0) * vy - (row - y0) * vx) / det
      if (!(b >= -tolerance)) continue
      const c = (ux * (row - y0) - uy * (column - x0)) / det
      const a = 1 - b - c
      if (a >= -tolerance && c >= -tolerance) visit(column, row, a, b, c)
    }
  }
}
