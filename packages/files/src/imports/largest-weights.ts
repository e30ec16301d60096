import type { GrayImage } from 'furrow'

/** Returns the largest weight of several areas per cell. */
export function largestWeights(areas: readonly GrayImage[]): GrayImage {
  const [{ width, height }] = areas
  const data = new Uint8Array(width * height)
  for (const area of areas) for (let i = 0; i < data.length; i++) data[i] = Math.max(data[i], area.data[i])
  return { width, height, data }
}
