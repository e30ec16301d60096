import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import { readImage } from './read-texture.ts'

/**
 * Decodes an image file in the browser, without colour management. Files of 16 bits a channel come out with 8.
 *
 * @param file PNG, JPEG, WebP or whatever else the browser reads.
 * @param who the file as an error shall name it.
 * @throws FurrowError when the file is empty, truncated, no image, larger than 8192 texels on a side, or
 *   transparent anywhere: a map means something at every texel.
 */
export async function decodeImage(file: Blob, who: string): Promise<RgbaImage> {
  if (file.size === 0) {
    throw new FurrowError({
      code: 'unreadable',
      who,
      what: 'empty file',
      value: '0 bytes',
      remedy: 'export the image again',
    })
  }
  const announced = await pngSize(file)
  if (announced) checkSize(announced.width, announced.height, who)
  const bitmap = await decode(file, who)
  checkSize(bitmap.width, bitmap.height, who)
  const image = readImage(bitmap)
  bitmap.close()
  checkOpaque(image, who)
  return image
}

/** Reduces colours to gray by the luma weights of ITU-R BT.601; grays keep their value exactly. */
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
    throw new FurrowError({
      code: 'unreadable',
      who,
      what: 'not a readable image',
      value: `${file.size} bytes`,
      limit: 'a whole PNG, JPEG or WebP file',
      remedy: 'export the image again; it may be cut off',
    })
  }
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

/** Size in a PNG's header, so that a huge image is refused before it is decoded; undefined for other files. */
async function pngSize(file: Blob): Promise<{ width: number; height: number } | undefined> {
  const head = new DataView(await file.slice(0, 24).arrayBuffer())
  const isPng = head.byteLength === 24 && head.getUint32(0) === 0x89504e47
  return isPng ? { width: head.getUint32(16), height: head.getUint32(20) } : undefined
}
