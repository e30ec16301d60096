/**
 * Extrapolation of heights beyond the border of a map. `wrap` repeats the map, for textures that tile. `clamp` continues the parabola through
 * the last three texels, so that slopes do not fade at the border.
 */
export type Edges = 'wrap' | 'clamp'

/** Maximum distance in texels from which a height affects a slope. */
export const SLOPE_REACH = 2

/**
 * Computes the slope at texel `i` of a row or column, in height per texel. The formula is the fourth-order central difference over five
 * texels (Fornberg 1988, Generation of finite difference formulas).
 *
 * @param start index of the first texel of the row or column.
 * @param stride difference between the indices of two neighbouring texels of the row or column.
 * @param count number of texels in the row or column.
 */
export function slopeAt(
  data: ArrayLike<number>,
  start: number,
  i: number,
  stride: number,
  count: number,
  edges: Edges,
): number {
  const index = start + i * stride
  if (i >= 2 && i < count - 2) {
    const near = data[index + stride] - data[index - stride]
    const far = data[index + 2 * stride] - data[index - 2 * stride]
    return (8 * near - far) / 12
  }
  return slopeAtBorder(data, start, i, stride, count, edges)
}

/** Computes `slopeAt` near the ends of a row or column. It is a separate function, so that `slopeAt` allocates no closure. */
function slopeAtBorder(
  data: ArrayLike<number>,
  start: number,
  i: number,
  stride: number,
  count: number,
  edges: Edges,
): number {
  const read = (k: number) =>
    edges === 'wrap'
      ? data[start + (((k % count) + count) % count) * stride]
      : extrapolate(data, start, k, stride, count)
  return (8 * (read(i + 1) - read(i - 1)) - (read(i + 2) - read(i - 2))) / 12
}

/** Returns the value at `k`. Outside the row or column, continues the parabola, line or constant through the last 3, 2 or 1 texels. */
function extrapolate(
  data: ArrayLike<number>,
  start: number,
  k: number,
  stride: number,
  count: number,
): number {
  if (k >= 0 && k < count) return data[start + k * stride]
  // `t` is the distance outwards from the border texel. `inner(n)` is the value at distance n inwards from the border texel.
  const t = k < 0 ? -k : k - count + 1
  const inner = (n: number) => data[start + (k < 0 ? n : count - 1 - n) * stride]
  if (count === 1) return inner(0)
  if (count === 2) return (1 + t) * inner(0) - t * inner(1)
  return ((t + 1) * (t + 2) * inner(0)) / 2 - t * (t + 2) * inner(1) + (t * (t + 1) * inner(2)) / 2
}
