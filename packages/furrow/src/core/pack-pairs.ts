import type { ImageArray } from './image-array.ts'
import type { GrayImage } from './types.ts'

/**
 * Packs two single-channel maps of each layer into the channels of one image, as occlusion and blood are.
 *
 * @param pairs of each layer both maps, at least one of which exists, all of one size, which is not checked; copied.
 * @param neutral what a map that is missing holds, 0..255.
 */
export function packPairs(
  pairs: readonly (readonly [GrayImage | undefined, GrayImage | undefined])[],
  neutral: readonly [number, number],
): ImageArray {
  const { width, height } = pairs.flat().find((image) => image)!
  const texels = width * height
  const data = new Uint8Array(2 * texels * pairs.length)
  for (const [slice, pair] of pairs.entries()) {
    const [first, second] = pair.map(
      (image, channel) => image?.data ?? new Uint8Array(texels).fill(neutral[channel]),
    )
    const start = 2 * texels * slice
    for (let i = 0; i < texels; i++) {
      data[start + 2 * i] = first[i]
      data[start + 2 * i + 1] = second[i]
    }
  }
  return { width, height, depth: pairs.length, channels: 2, data }
}
