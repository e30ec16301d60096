import type { GrayImage, RgbaImage } from './types.ts'

/** Channels of single-value maps in their images, as in glTF: 0 = R to 2 = B. Blood is in the image of the occlusion. */
export const CHANNEL = { occlusion: 0, roughness: 1, blood: 2, height: 0 } as const

/**
 * Extracts one channel of an image, its values unchanged.
 *
 * @param channel 0 = R to 3 = A.
 */
export function channelOf({ width, height, data }: RgbaImage, channel: number): GrayImage {
  const values = new Uint8Array(width * height)
  for (let i = 0; i < values.length; i++) values[i] = data[4 * i + channel]
  return { width, height, data: values }
}
