import type { GrayImage } from 'furrow'
import type { Pixels } from './pixels.ts'

/** The weights of an area as it is painted, in the paper's convention: white = no wrinkles. */
export function paintedArea({ width, height, data }: GrayImage): Pixels {
  const gray = new Uint8Array(data.length)
  // `map` calls a function for each texel, of which there may be 67 million: it takes more than twice as long.
  for (let i = 0; i < data.length; i++) gray[i] = 255 - data[i]
  return { width, height, channels: 1, data: gray }
}
