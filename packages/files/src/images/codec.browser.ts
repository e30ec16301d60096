import { inflateImage, readImage } from 'furrow/internal'
import { checkImageSize, checkImageType, GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { headerOf } from './header.ts'
import { withImageErrors } from './image-errors.ts'
import type { DecodedImage, Pixels } from './pixels.ts'
import { encodePortablePng } from './png.ts'

/**
 * Reads the header of an image; one of WebP or AVIF is decoded for it, by the browser's own limits.
 *
 * @param name of the image, for errors.
 * @param types the formats that are allowed, known by their first bytes.
 * @throws FurrowError when it is in another format, damaged, longer than 8192 texels on a side, or would take too much
 *   memory.
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
 * Decodes an image to 8 bits per channel, as stored: without colour profiles, and not multiplied by alpha. What libvips
 * gives and what browsers give is the same for PNG; of lossy formats a texel may differ by 1.
 *
 * @throws FurrowError as `measureImage` does, and where it cannot be decoded.
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

/** A map as a PNG file with the same channels, for what no packed face holds: there, the bytes must be the same everywhere. */
export async function encodeMap(pixels: Pixels): Promise<Uint8Array> {
  return encodePortablePng(pixels)
}

/** Decodes an image to see that it can be. Throws FurrowError as `decodeImage` does. */
export async function checkWhole(bytes: Uint8Array, name: string, who: string): Promise<void> {
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
