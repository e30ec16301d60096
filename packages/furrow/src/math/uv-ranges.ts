type Range = [least: number, largest: number]

/** Smallest and largest texture coordinates u and v of a mesh. */
export type UvRanges = readonly [u: Range, v: Range]

/**
 * Computes the ranges of the texture coordinates of a mesh.
 *
 * @param read returns u (axis 0) or v (axis 1) of a vertex.
 */
export function uvRanges(vertices: number, read: (vertex: number, axis: number) => number): UvRanges {
  const rangeOf = (axis: number) => {
    const range: Range = [Infinity, -Infinity]
    for (let i = 0; i < vertices; i++) {
      const coordinate = read(i, axis)
      range[0] = Math.min(range[0], coordinate)
      range[1] = Math.max(range[1], coordinate)
    }
    return range
  }
  return [rangeOf(0), rangeOf(1)]
}

/**
 * Whether texture coordinates of a mesh may be outside 0..1 after a transform. Neighbouring pixels can then sample opposite edges of a map.
 * Only the corners of the ranges are tested. If the transform rotates, the result may be true although no vertex is outside 0..1.
 *
 * @param a, b, c, d, e, f coefficients of the transform: the map is sampled at `(a * u + b * v + c, d * u + e * v + f)`.
 */
export function isTiledBy(
  ranges: UvRanges,
  a: number,
  b: number,
  c: number,
  d: number,
  e: number,
  f: number,
): boolean {
  // This loop allocates nothing, because the Babylon.js renderer calls the function in every frame.
  for (let corner = 0; corner < 4; corner++) {
    const u = ranges[0][corner & 1]
    const v = ranges[1][corner >> 1]
    const x = a * u + b * v + c
    const y = d * u + e * v + f
    if (Math.min(x, y) < 0 || Math.max(x, y) > 1) return true
  }
  return false
}
