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
 * True of all that a rotated map may have so.
 *
 * @param place where a map has the coordinates u and v.
 */
export function isTiledBy(
  [us, vs]: UvRanges,
  place: (u: number, v: number) => Readonly<{ x: number; y: number }>,
): boolean {
  return us.some((u) =>
    vs.some((v) => {
      const { x, y } = place(u, v)
      return Math.min(x, y) < 0 || Math.max(x, y) > 1
    }),
  )
}
