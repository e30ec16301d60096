import type { GrayImage } from 'furrow'

/** Returns the largest weight of several areas per cell. */
export function largestWeights(areas: readonly GrayImage[]): GrayImage {
  const [{ width, height }] = areas
  const data = new Uint8Array(width * height)
  for (const area of areas) for (let i = 0; i < data.length; i++) data[i] = Math.max(data[i], area.data[i])
  return { width, height, data }
}

/** Returns the sum of the weights of several areas per cell, 0..255 per area. At most 257 areas. */
export function sumsOfWeights(areas: readonly GrayImage[]): Uint16Array {
  const sums = new Uint16Array(areas[0].data.length)
  for (const { data } of areas) for (let i = 0; i < sums.length; i++) sums[i] += data[i]
  return sums
}
