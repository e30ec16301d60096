type Range = [least: number, largest: number]

/** Of the u and v of a mesh. */
export type UvRanges = readonly [u: Range, v: Range]

/** @param read one coordinate of a vertex: 0 is u, 1 is v. */
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
 * Whether texture coordinates leave 0..1 somewhere on a mesh, and so wrap: neighbouring pixels may then be at opposite edges of its maps.
 * True of all that a rotated map may have so. A map has the coordinates u and v at a u + b v + c and d u + e v + f.
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
  // Without closures: Babylon.js asks in every frame.
  for (let corner = 0; corner < 4; corner++) {
    const u = ranges[0][corner & 1]
    const v = ranges[1][corner >> 1]
    const x = a * u + b * v + c
    const y = d * u + e * v + f
    if (Math.min(x, y) < 0 || Math.max(x, y) > 1) return true
  }
  return false
}
