import type { RgbaImage } from 'furrow/author'
import sharp from 'sharp'
import { cannotRead } from '../errors.ts'

/**
 * Decodes a normal map (any format that sharp reads) to RGBA bytes with alpha 255.
 *
 * @param name of the image, for errors.
 * @param size side in texels to scale it to; its own by default.
 * @throws FurrowError when the bytes cannot be decoded.
 */
export async function decodeNormalMap(
  bytes: Uint8Array,
  name: string,
  who: string,
  size?: number,
): Promise<RgbaImage> {
  try {
    let image = sharp(bytes).toColourspace('srgb').removeAlpha()
    if (size !== undefined) image = image.resize(size, size, { fit: 'fill', kernel: 'cubic' })
    const { data, info } = await image.raw().toBuffer({ resolveWithObject: true })
    const { width, height, channels } = info
    const rgba = new Uint8Array(4 * width * height).fill(255)
    for (let i = 0; i < width * height; i++) {
      for (let k = 0; k < 3; k++) rgba[4 * i + k] = data[channels * i + Math.min(k, channels - 1)]
    }
    return { width, height, data: rgba }
  } catch (error) {
    throw cannotRead(who, `the normal map ${name}`, error, { remedy: 'use a PNG, JPEG or WebP file' })
  }
}
