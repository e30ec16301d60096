import type { RgbaImage } from '../../core/types.ts'

/** The pixels of an image without alpha, which a 2D canvas keeps as they are; the image is closed. */
export function readOpaque(bitmap: ImageBitmap): RgbaImage {
  // Outside of browsers, a decoder that stands in for the browser's has the pixels.
  if ('data' in bitmap) return bitmap as RgbaImage
  const { width, height } = bitmap
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!
  context.drawImage(bitmap, 0, 0)
  bitmap.close()
  const { data } = context.getImageData(0, 0, width, height)
  return { width, height, data: new Uint8Array(data.buffer) }
}
