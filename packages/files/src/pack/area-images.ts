import type { GrayImage } from 'furrow'
import type { Pixels } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import type { FileImage } from './embed.ts'

/** Number of areas in one image, one per channel. An area contains the weights of a group of wrinkles in UV space. */
export type AreasPerImage = 1 | 3 | 4

/**
 * Encodes areas of equal size as channels of PNG images, in order.
 *
 * @param encode PNG encoder. The default writes the same bytes in Node and in all browsers.
 */
export function encodeAreaImages(
  weights: readonly GrayImage[],
  areasPerImage: AreasPerImage,
  encode: (pixels: Pixels) => Uint8Array | Promise<Uint8Array> = encodePortablePng,
): Promise<FileImage[]> {
  const images = Array.from({ length: Math.ceil(weights.length / areasPerImage) }, async (_, i) => {
    const group = weights.slice(i * areasPerImage, (i + 1) * areasPerImage)
    const channels = group.length === 2 ? 3 : (group.length as AreasPerImage)
    const bytes = await encode(interleave(group, channels))
    return { name: `areas ${i + 1}`, mimeType: 'image/png', bytes }
  })
  return Promise.all(images)
}

/** Combines areas of equal size as channels of one image. Unused channels are 0. */
export function interleave(weights: readonly GrayImage[], channels: Pixels['channels']): Pixels {
  const { width, height } = weights[0]
  const data = new Uint8Array(channels * width * height)
  for (const [k, area] of weights.entries()) {
    for (let i = 0; i < area.data.length; i++) data[channels * i + k] = area.data[i]
  }
  return { width, height, channels, data }
}
