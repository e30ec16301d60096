import type { GrayImage, RgbaImage } from './types.ts'

/** Channels of single-value maps in their images, as in glTF: 0 = R to 2 = B. Blood is in the image of the occlusion. */
export const CHANNEL = { occlusion: 0, roughness: 1, blood: 2, height: 0 } as const

/**
 * Extracts one channel of an image, its values unchanged.
 *
 * @param channel 0 = R to 3 = A.
 */
export function channelOf({ width, height, data }: RgbaImage, channel: number): GrayImage {
  return { width, height, data: Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + channel]) }
}
