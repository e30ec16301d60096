import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { imageDamage } from '../../core/maps/image-file.ts'
import { imageTypeOf } from '../../core/maps/image-type.ts'
import { type PngHeader, pngHeader } from '../../core/maps/png.ts'
import type { RgbaImage } from '../../core/types.ts'
import { tooLarge, unreadable } from './image-faults.ts'
import { inflatePng } from './inflate-png.ts'
import { readOpaque } from './opaque-image.ts'

/**
 * Decodes an image that is not the usual PNG: JPEG, WebP and AVIF, PNG with alpha or a palette. Fetched for files that have any.
 *
 * @throws FurrowError that says what is wrong with a file that is none of these, or damaged, or too large.
 */
export async function decodeOther(bytes: Uint8Array<ArrayBuffer>, who: string): Promise<RgbaImage> {
  const type = imageTypeOf(bytes)
  const damage = imageDamage(bytes)
  if (damage || !type || type === 'image/ktx2') throw unreadable(bytes, who, damage)
  const png = pngHeader(bytes)
  // To refuse huge images before they are decoded.
  if (png) checkSize(png, who)
  try {
    if (png && hasPlainAlpha(png)) return await inflatePng(bytes, png)
    const isOpaque = type === 'image/jpeg'
    const bitmap = await createImageBitmap(new Blob([bytes], { type }), {
      colorSpaceConversion: 'none',
      premultiplyAlpha: isOpaque ? 'premultiply' : 'none',
    })
    checkSize(bitmap, who)
    if (isOpaque) return readOpaque(bitmap)
    const image = (await import('./read-image.ts')).readImage(bitmap)
    bitmap.close()
    return image
  } catch (error) {
    throw error instanceof FurrowError ? error : unreadable(bytes, who)
  }
}

function checkSize(size: { width: number; height: number }, who: string): void {
  if (Math.max(size.width, size.height) > MAX_IMAGE_SIDE) throw tooLarge(size, who)
}

/** Whether `inflatePng` reads a file. */
function hasPlainAlpha({ depth, colour, isInterlaced }: PngHeader): boolean {
  return depth === 8 && (colour === 4 || colour === 6) && !isInterlaced
}
