import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { isWholePng, type PngHeader, pngChunks, pngHeader } from '../../core/maps/png.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import { readOpaque } from './opaque-image.ts'

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
  const png = pngHeader(bytes)
  if (!png || !isUsual(png, bytes)) return (await import('./other-image.ts')).decodeOther(bytes, who)
  try {
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), {
      colorSpaceConversion: 'none',
      // The same where there is no alpha, and what canvases hold: nothing is converted, which would take a third of the time.
      premultiplyAlpha: 'premultiply',
    })
    return readOpaque(bitmap)
  } catch {
    throw (await faults()).unreadable(bytes, who)
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

/**
 * Whether a PNG is as most maps are: whole, of a size that is allowed, gray or RGB, with no colour that stands for transparency. All else
 * is left to what is fetched for it.
 */
function isUsual({ width, height, colour }: PngHeader, bytes: Uint8Array): boolean {
  if (Math.max(width, height) > MAX_IMAGE_SIDE || (colour !== 0 && colour !== 2)) return false
  const chunks = pngChunks(bytes)
  return isWholePng(chunks) && chunks.every(({ type }) => type !== 'tRNS')
}
