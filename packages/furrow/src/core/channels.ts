import type { GrayImage, RgbaImage } from './types.ts'

/** Channels of single-value maps in their images, as in glTF: 0 = R to 2 = B. Blood shares the image of occlusion. */
export const CHANNEL = { occlusion: 0, roughness: 1, blood: 2, height: 0 } as const

/**
 * Extracts one channel of an image.
 *
 * @param channel 0 = R to 3 = A.
 */
export function channelOf({ width, height, data }: RgbaImage, channel: number): GrayImage {
  // A Uint8Array made from these 32-bit texels keeps their lowest bytes. This is several times faster than a loop that is not yet optimised.
  const texels = new Uint8Array(4 * width * height)
  texels.set(data.subarray(channel))
  return { width, height, data: new Uint8Array(new Uint32Array(texels.buffer)) }
}
