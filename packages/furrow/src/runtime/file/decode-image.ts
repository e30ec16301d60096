import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import { imageDamage, imageTypeOf } from '../../core/maps/image-file.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import { readImage } from './read-image.ts'

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
  checkOpaque(image, who)
  return image
}

/** As `decodeImage`, with alpha as stored. */
export async function decodeBytes(bytes: Uint8Array<ArrayBuffer>, who: string): Promise<RgbaImage> {
  if (bytes.length === 0) {
    throw new FurrowError({
      code: 'unreadable',
      who,
      what: 'empty file',
      value: '0 bytes',
      remedy: 'export the image again',
    })
  }
  const type = imageTypeOf(bytes)
  if (type === undefined || type === 'image/ktx2') throw notReadable(who, `${bytes.length} bytes`)
  const damage = imageDamage(bytes)
  if (damage) throw notReadable(who, damage)
  if (type === 'image/png') checkPngSize(bytes, who)
  const bitmap = await decode(new Blob([bytes], { type }), who)
  checkSize(bitmap.width, bitmap.height, who)
  const image = readImage(bitmap)
  bitmap.close()
  return image
}

/** Converts colours, as stored, to gray by the luma weights of ITU-R BT.601. Grays keep their value exactly. */
export function toGray({ width, height, data }: RgbaImage): GrayImage {
  const gray = new Uint8Array(width * height)
  for (let i = 0; i < gray.length; i++) {
    gray[i] = Math.round(0.299 * data[4 * i] + 0.587 * data[4 * i + 1] + 0.114 * data[4 * i + 2])
  }
  return { width, height, data: gray }
}

async function decode(file: Blob, who: string): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(file, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' })
  } catch {
    throw notReadable(who, `${file.size} bytes`)
  }
}

function notReadable(who: string, value: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    what: 'not a readable image',
    value,
    limit: 'a whole PNG, JPEG, WebP or AVIF file',
    remedy: 'export the image again; it may be cut off',
  })
}

function checkSize(width: number, height: number, who: string): void {
  if (Math.max(width, height) <= MAX_IMAGE_SIDE) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    what: 'image too large',
    value: `${width} x ${height}`,
    limit: `${MAX_IMAGE_SIDE} texels on a side`,
    remedy: 'scale it down; areas need 128 texels, normal maps 1024 to 4096',
  })
}

function checkOpaque({ data }: RgbaImage, who: string): void {
  for (let i = 3; i < data.length; i += 4) {
    if (data[i] === 255) continue
    throw new FurrowError({
      who,
      what: 'image with transparent texels',
      value: `alpha ${data[i]}`,
      limit: 'alpha 255 throughout',
      remedy: 'flatten it onto white (an area) or onto 128, 128, 255 (a normal map)',
    })
  }
}

/** By the header, to refuse huge images before they are decoded. The first chunk is whole. */
function checkPngSize(bytes: Uint8Array, who: string): void {
  const header = new DataView(bytes.buffer, bytes.byteOffset)
  checkSize(header.getUint32(16), header.getUint32(20), who)
}
