import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { imageTypeOf } from '../../core/maps/image-type.ts'
import { type PngChunk, type PngHeader, pngChunks, pngDamage, pngHeader } from '../../core/maps/png.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'

/**
 * Decodes an image file in the browser, without colour management, to 8 bits per channel.
 *
 * @param file PNG, JPEG, WebP or AVIF.
 * @param who names the file in errors.
 * @returns colours as stored, alpha 255.
 * @throws FurrowError when the file is empty, damaged or not such an image, larger than 8192 texels on a side, or has transparent texels:
 *   every texel of a map counts.
 */
export async function decodeImage(file: Blob, who: string): Promise<RgbaImage> {
  const image = await decodeBytes(new Uint8Array(await file.arrayBuffer()), who)
  const { data } = image
  for (let i = 3; i < data.length; i += 4) {
    if (data[i] !== 255) throw (await faults()).transparent(data[i], who)
  }
  return image
}

/** As `decodeImage`, with alpha as stored. */
export async function decodeBytes(bytes: Uint8Array<ArrayBuffer>, who: string): Promise<RgbaImage> {
  const type = imageTypeOf(bytes)
  const chunks = type === 'image/png' ? pngChunks(bytes) : null
  const isJpeg = type === 'image/jpeg'
  // As `imageDamage` does.
  const damage = chunks ? pngDamage(chunks) : isJpeg ? (await importJpeg()).jpegDamage(bytes) : undefined
  if (damage || !type || type === 'image/ktx2') throw (await faults()).unreadable(bytes, who, damage)
  const png = chunks && pngHeader(bytes)
  // To refuse huge images before they are decoded.
  if (png) await checkSize(png, who)
  try {
    if (png && hasPlainAlpha(png)) return await (await import('./inflate-png.ts')).inflatePng(chunks, png)
    const isOpaque = isJpeg || (png && hasNoAlpha(png, chunks))
    const bitmap = await createImageBitmap(new Blob([bytes], { type }), {
      colorSpaceConversion: 'none',
      // The same where there is no alpha, and what canvases hold: nothing is converted, which would take a third of the time.
      premultiplyAlpha: isOpaque ? 'premultiply' : 'none',
    })
    await checkSize(bitmap, who)
    const image = isOpaque ? readOpaque(bitmap) : (await import('./read-image.ts')).readImage(bitmap)
    bitmap.close()
    return image
  } catch (error) {
    throw error instanceof FurrowError ? error : (await faults()).unreadable(bytes, who)
  }
}

/** Converts colours, as stored, to gray by the luma weights of ITU-R BT.601. Grays keep their value exactly. */
export function toGray({ width, height, data }: RgbaImage): GrayImage {
  const gray = new Uint8Array(width * height)
  for (let i = 0; i < gray.length; i++) {
    gray[i] = Math.round(0.299 * data[4 * i] + 0.587 * data[4 * i + 1] + 0.114 * data[4 * i + 2])
  }
  return { width, height, data: gray }
}

/** What says what is wrong with a file: fetched, since most are sound. */
export const faults = () => import('./image-faults.ts')

const importJpeg = () => import('../../core/maps/jpeg.ts')

async function checkSize(size: { width: number; height: number }, who: string): Promise<void> {
  if (Math.max(size.width, size.height) > MAX_IMAGE_SIDE) throw (await faults()).tooLarge(size, who)
}

/** Whether `inflatePng` reads a file. */
function hasPlainAlpha({ depth, colour, isInterlaced }: PngHeader): boolean {
  return depth === 8 && (colour === 4 || colour === 6) && !isInterlaced
}

/** Whether a file is gray or RGB, with no colour that stands for transparency. */
function hasNoAlpha({ colour }: PngHeader, chunks: readonly PngChunk[]): boolean {
  return (colour === 0 || colour === 2) && chunks.every(({ type }) => type !== 'tRNS')
}

/** The pixels of an image without alpha, which a 2D canvas keeps as they are. */
function readOpaque(bitmap: ImageBitmap): RgbaImage {
  // Outside of browsers, a decoder that stands in for the browser's has the pixels.
  if ('data' in bitmap) return bitmap as RgbaImage
  const { width, height } = bitmap
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!
  context.drawImage(bitmap, 0, 0)
  const { data } = context.getImageData(0, 0, width, height)
  return { width, height, data: new Uint8Array(data.buffer) }
}
