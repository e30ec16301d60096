import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { imageDamage, pngDamage } from '../../core/maps/image-file.ts'
import { imageTypeOf } from '../../core/maps/image-type.ts'
import { type PngChunk, type PngHeader, pngChunks, pngHeader } from '../../core/maps/png.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import { tooLarge, transparent, unreadable } from './image-errors.ts'
import { inflatePng } from './inflate-png.ts'
import { readImage, readOpaque } from './read-image.ts'

/**
 * Decodes an image file in the browser to 8 bits per channel, without colour management.
 *
 * @param file PNG, JPEG, WebP or AVIF.
 * @param who name of the file in errors.
 * @returns the colours as stored in the file, with alpha 255.
 * @throws FurrowError if the file is empty, damaged or in another format, or if the image has transparent texels or is wider or higher
 *   than 8192 texels.
 */
export async function decodeImage(file: Blob, who: string): Promise<RgbaImage> {
  const image = await decodeBytes(new Uint8Array(await file.arrayBuffer()), who)
  const { data } = image
  for (let i = 3; i < data.length; i += 4) {
    if (data[i] !== 255) throw transparent(data[i], who)
  }
  return image
}

/** Decodes an image file as `decodeImage` does, but keeps the stored alpha instead of rejecting transparent texels. */
export async function decodeBytes(bytes: Uint8Array<ArrayBuffer>, who: string): Promise<RgbaImage> {
  const type = imageTypeOf(bytes)
  const png = pngHeader(bytes)
  const chunks = png ? pngChunks(bytes) : []
  const damage = png ? pngDamage(chunks) : imageDamage(bytes)
  if (damage || !type || type === 'image/ktx2') throw unreadable(bytes, who, damage)
  // The size in a PNG header is checked before decoding, because decoding a huge image may exhaust memory.
  if (png) checkSize(png, who)
  try {
    if (png && canInflate(png, chunks)) return await inflatePng(chunks, png)
    const isOpaque = type === 'image/jpeg' || (png !== undefined && !hasAlpha(png, chunks))
    const bitmap = await createImageBitmap(new Blob([bytes], { type }), {
      colorSpaceConversion: 'none',
      // Premultiplying does not change opaque images. It makes decoding three times as fast, because canvases store premultiplied colours.
      premultiplyAlpha: isOpaque ? 'premultiply' : 'none',
    })
    checkSize(bitmap, who)
    const image = isOpaque ? readOpaque(bitmap) : readImage(bitmap)
    bitmap.close?.()
    return image
  } catch (error) {
    throw error instanceof FurrowError ? error : unreadable(bytes, who)
  }
}

/** Decodes a PNG file with alpha or 16 bits per channel, which a canvas cannot decode exactly. Returns undefined for other files. */
export async function inflateImage(bytes: Uint8Array): Promise<RgbaImage | undefined> {
  const png = pngHeader(bytes)
  const chunks = png ? pngChunks(bytes) : []
  return png && canInflate(png, chunks) ? inflatePng(chunks, png) : undefined
}

/** Converts colours to gray with the luma weights of ITU-R BT.601. Texels that are already gray keep their value. */
export function toGray({ width, height, data }: RgbaImage): GrayImage {
  const gray = new Uint8Array(width * height)
  for (let i = 0; i < gray.length; i++) {
    gray[i] = Math.round(0.299 * data[4 * i] + 0.587 * data[4 * i + 1] + 0.114 * data[4 * i + 2])
  }
  return { width, height, data: gray }
}

function checkSize(size: { width: number; height: number }, who: string): void {
  if (Math.max(size.width, size.height) > MAX_IMAGE_SIDE) throw tooLarge(size, who)
}

/** Whether a PNG may have transparency: an alpha channel, a palette or a tRNS chunk. */
function hasAlpha({ colour }: PngHeader, chunks: readonly PngChunk[]): boolean {
  return (colour !== 0 && colour !== 2) || chunks.some(({ type }) => type === 'tRNS')
}

/** Whether a PNG file has alpha or 16 bits per channel, and `inflatePng` supports it. */
function canInflate({ depth, colour, isInterlaced }: PngHeader, chunks: readonly PngChunk[]): boolean {
  if (isInterlaced) return false
  if (colour === 4 || colour === 6) return depth >= 8
  return depth === 16 && !chunks.some(({ type }) => type === 'tRNS')
}
