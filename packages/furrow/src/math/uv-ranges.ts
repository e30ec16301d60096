type Range = [least: number, largest: number]

/** Ranges of u and v in a mesh. */
export type UvRanges = readonly [u: Range, v: Range]

/** @param read returns a coordinate of a vertex: axis 0 is u, 1 is v. */
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
 * Whether texture coordinates may leave 0..1 on a mesh, so that neighbouring pixels can sample opposite edges of a map. Conservative for
 * rotated maps. The map is sampled at (a u + b v + c, d u + e v + f).
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
  // No closures, because Babylon.js calls this every frame.
  for (let corner = 0; corner < 4; corner++) {
    const u = ranges[0][corner & 1]
    const v = ranges[1][corner >> 1]
    const x = a * u + b * v + c
    const y = d * u + e * v + f
    if (Math.min(x, y) < 0 || Math.max(x, y) > 1) return true
  }
  return false
}
