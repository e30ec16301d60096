import type { GrayImage, RgbaImage } from './types.ts'

/**
 * Images of one size in one buffer. Texel (x, y) of slice d starts at index `(x + y * width + d * width * height) * channels`.
 */
export interface ImageArray {
  width: number
  height: number
  /** Number of images (slices). */
  depth: number
  channels: 1 | 2 | 4
  /** width x height x depth x channels bytes. */
  data: Uint8Array
}

/**
 * Copies images into one array.
 *
 * @param images at least one image. All must have the same size, which is not checked.
 */
export function imageArray(images: readonly (GrayImage | RgbaImage)[], channels: 1 | 4): ImageArray {
  const [{ width, height }] = images
  const stride = width * height * channels
  const data = new Uint8Array(stride * images.length)
  for (const [index, image] of images.entries()) data.set(image.data, index * stride)
  return { width, height, depth: images.length, channels, data }
}
