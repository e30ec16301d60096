import type { GrayImage, RgbaImage } from './types.ts'

/** Image channel that stores each single-channel map: 0 = R, 1 = G, 2 = B. Blood and onset are stored in the image of the occlusion map. */
export const CHANNEL = { occlusion: 0, roughness: 1, blood: 2, onset: 1, height: 0 } as const

/**
 * Extracts one channel of an image.
 *
 * @param channel 0 = R to 3 = A.
 */
export function channelOf({ width, height, data }: RgbaImage, channel: number): GrayImage {
  // The copy starts at the channel, so the channel is the lowest byte of each 32-bit texel. Converting 32-bit texels to a Uint8Array keeps
  // only the lowest bytes. A loop would be several times slower until the JIT compiler optimises it.
  const texels = new Uint8Array(4 * width * height)
  texels.set(data.subarray(channel))
  return { width, height, data: new Uint8Array(new Uint32Array(texels.buffer)) }
}
