import type { ImageArray } from './image-array.ts'
import type { GrayImage } from './types.ts'

/**
 * Packs two single-channel maps of each layer, such as occlusion and blood, into the channels of one image.
 *
 * @param pairs two maps per layer, at least one present; copied. All must have one size (unchecked).
 * @param neutral fill values for missing maps, 0..255.
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
