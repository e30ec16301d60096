/**
 * Visits the texels whose centres a triangle covers, with the shares of its corners there.
 *
 * @param uvs u and v per vertex, v = 0 at the top.
 * @param corners the triangle's three vertices.
 * @param visit is given the texel's index, row by row, and three shares that sum to 1.
 */
export function coverTexels(
  uvs: ArrayLike<number>,
  corners: readonly [number, number, number],
  width: number,
  height: number,
  visit: (texel: number, a: number, b: number, c: number) => void,
): void {
  const x = corners.map((i) => uvs[2 * i] * width - 0.5)
  const y = corners.map((i) => uvs[2 * i + 1] * height - 0.5)
  const det = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
  if (Math.abs(det) < 1e-9) return
  const firstRow = Math.max(Math.ceil(Math.min(...y)), 0)
  const lastRow = Math.min(Math.floor(Math.max(...y)), height - 1)
  const firstColumn = Math.max(Math.ceil(Math.min(...x)), 0)
  const lastColumn = Math.min(Math.floor(Math.max(...x)), width - 1)
  for (let row = firstRow; row <= lastRow; row++) {
    for (let column = firstColumn; column <= lastColumn; column++) {
      const b = ((column - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (row - y[0])) / det
      const c = ((x[1] - x[0]) * (row - y[0]) - (column - x[0]) * (y[1] - y[0])) / det
      const a = 1 - b - c
      if (a >= -1e-6 && b >= -1e-6 && c >= -1e-6) visit(row * width + column, a, b, c)
    }
  }
}
