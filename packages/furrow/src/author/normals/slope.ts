/**
 * How a map continues beyond its border. `wrap`: with the opposite side, for a texture that tiles. `clamp`: by extrapolating the
 * parabola through the last three texels, so that a slope does not fade at the border.
 */
export type Edges = 'wrap' | 'clamp'

/** Texels to either side whose values a slope depends on, at a border as well. */
export const SLOPE_REACH = 2

/**
 * Slope per texel at texel `i` of a row or column: central difference of fourth order over five texels (Fornberg 1988, Generation of
 * finite difference formulas).
 *
 * @param start index of the line's first texel.
 * @param stride from texel to texel of the line.
 * @param count texels of the line.
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

/** Apart from `slopeAt`, whose every call would otherwise make the function in it. */
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

/** The value at `k`; outside, that of the parabola, line or constant through the nearest texels. */
function extrapolate(
  data: ArrayLike<number>,
  start: number,
  k: number,
  stride: number,
  count: number,
): number {
  if (k >= 0 && k < count) return data[start + k * stride]
  // t texels beyond the border; its own texel is 0 and those inwards are 1 and 2.
  const t = k < 0 ? -k : k - count + 1
  const inner = (n: number) => data[start + (k < 0 ? n : count - 1 - n) * stride]
  if (count === 1) return inner(0)
  if (count === 2) return (1 + t) * inner(0) - t * inner(1)
  return ((t + 1) * (t + 2) * inner(0)) / 2 - t * (t + 2) * inner(1) + (t * (t + 1) * inner(2)) / 2
}
