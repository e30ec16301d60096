import { inflateImage, readImage } from 'furrow/internal'
import { checkImageSize, checkImageType, GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { headerOf } from './header.ts'
import { withImageErrors } from './image-errors.ts'
import type { DecodedImage, Pixels } from './pixels.ts'
import { encodePortablePng } from './png.ts'

/**
 * Reads the format and size of an image. Decodes WebP and AVIF to get their size.
 *
 * @param name name of the image, for errors.
 * @param types allowed formats.
 * @throws FurrowError if the image has another format, is damaged, is larger than 8192 texels per side, or would take
 *   too much memory.
 */
export async function measureImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<ImageHeader> {
  const type = checkImageType(bytes, name, who, types)
  const { width, height, texelBytes } = headerOf(bytes, type) ?? (await measureBitmap(bytes, name, who))
  const header = { type, width, height, decodedBytes: width * height * texelBytes }
  checkImageSize(header, name, who)
  return header
}

/**
 * Decodes an image to 8 bits per channel. Ignores colour profiles and does not premultiply alpha. PNG gives the same
 * values as libvips in Node. Values from lossy formats may differ from those of libvips by 1.
 *
 * @throws FurrowError like `measureImage`, and if the image cannot be decoded.
 */
export async function decodeImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<DecodedImage> {
  const { type } = await measureImage(bytes, name, who, types)
  const bitmap = await bitmapOf(bytes, name, who)
  try {
    const pixels = await withImageErrors(
      name,
      who,
      async () => (await inflateImage(bytes)) ?? readImage(bitmap),
    )
    return { type, channels: 4, ...pixels }
  } finally {
    bitmap.close()
  }
}

/** Encodes a map as PNG. The function of this name for Node writes the same pixels, but compressed by libvips. */
export async function encodeMap(pixels: Pixels): Promise<Uint8Array> {
  return encodePortablePng(pixels)
}

/** Decodes a whole image to check it. Throws like `decodeImage`. */
export async function checkDecodable(bytes: Uint8Array, name: string, who: string): Promise<void> {
  await measureImage(bytes, name, who)
  const bitmap = await bitmapOf(bytes, name, who)
  bitmap.close()
}

async function measureBitmap(bytes: Uint8Array, name: string, who: string) {
  const bitmap = await bitmapOf(bytes, name, who)
  const { width, height } = bitmap
  bitmap.close()
  return { width, height, texelBytes: 4 }
}

function bitmapOf(bytes: Uint8Array, name: string, who: string): Promise<ImageBitmap> {
  const file = new Blob([bytes as Uint8Array<ArrayBuffer>])
  return withImageErrors(name, who, () => {
    return createImageBitmap(file, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' })
  })
}
