import type { GrayImage } from 'furrow'
import type { Pixels } from './pixels.ts'

/** Inverts the weights of an area, so that black = visible as in the paper (Reis, De Martino and Batagelo 2008). */
export function paintedArea({ width, height, data }: GrayImage): Pixels {
  const gray = new Uint8Array(data.length)
  // For large images, `map` takes more than twice as long as this loop.
  for (let i = 0; i < data.length; i++) gray[i] = 255 - data[i]
  return { width, height, channels: 1, data: gray }
}
