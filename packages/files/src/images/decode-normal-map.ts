import type { RgbaImage } from 'furrow/author'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'

/** Default maximum width and height, texels. Drawing strokes over a map takes several times the memory of the map. */
const DEFAULT_MAX_SIDE = 4096

/**
 * Decodes a normal map to RGBA bytes with alpha 255. Ignores colour profiles.
 *
 * @param name name of the image, for errors.
 * @param size width and height of the result, texels. Default: the size of the image, scaled down to at most 4096.
 * @throws FurrowError like `openImage`, and if the image cannot be decoded.
 */
export async function decodeNormalMap(
  bytes: Uint8Array,
  name: string,
  who: string,
  size?: number,
): Promise<RgbaImage> {
  const opened = await openImage(bytes, name, who)
  let image = opened.image.toColourspace('srgb').removeAlpha()
  if (size !== undefined) image = image.resize(size, size, { fit: 'fill', kernel: 'cubic' })
  else if (Math.max(opened.width, opened.height) > DEFAULT_MAX_SIDE) {
    image = image.resize(DEFAULT_MAX_SIDE, DEFAULT_MAX_SIDE, { fit: 'inside', kernel: 'cubic' })
  }
  const decode = () => image.raw().toBuffer({ resolveWithObject: true })
  const { data, info } = await withImageErrors(name, who, decode)
  const { width, height, channels } = info
  const rgba = new Uint8Array(4 * width * height).fill(255)
  for (let i = 0; i < width * height; i++) {
    for (let k = 0; k < 3; k++) rgba[4 * i + k] = data[channels * i + Math.min(k, channels - 1)]
  }
  return { width, height, data: rgba }
}
