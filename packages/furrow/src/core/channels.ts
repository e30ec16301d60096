import type { GrayImage, RgbaImage } from './types.ts'

/** Which channel of its image a map of one value per texel lies in: glTF's own choice. */
export const CHANNEL = { occlusion: 0, roughness: 1 } as const

/**
 * One channel of an image, as it is.
 *
 * @param channel 0 = R to 3 = A.
 */
export function channelOf({ width, height, data }: RgbaImage, channel: number): GrayImage {
  return { width, height, data: Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + channel]) }
}
