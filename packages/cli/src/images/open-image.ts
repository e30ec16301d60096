import { FurrowError, imageDamage, imageTypeOf, MAX_IMAGE_SIDE } from 'furrow'
import sharp, { type Metadata, type Sharp } from 'sharp'
import { cannotRead } from '../errors.ts'
import { kindOf } from '../file-kind.ts'
import { checkDecodedBytes } from './decoded-bytes.ts'
import { REPAIR, withImageErrors } from './image-errors.ts'

// What is opened has been looked at; this keeps libvips from its other readers, whatever it takes a file for.
sharp.block({ operation: ['VipsForeignLoad'] })
sharp.unblock({
  operation: ['Png', 'Jpeg', 'Webp', 'Heif', 'Tiff'].map((format) => `VipsForeignLoad${format}`),
})

const FORMATS = {
  'image/png': 'PNG',
  'image/jpeg': 'JPEG',
  'image/webp': 'WebP',
  'image/avif': 'AVIF',
  'image/tiff': 'TIFF',
} as const

export type ImageType = keyof typeof FORMATS

/** Formats of painted images. */
const PAINTED: readonly ImageType[] = ['image/png', 'image/jpeg', 'image/webp']
/** Formats of images in glTF files. */
export const GLTF_IMAGES: readonly ImageType[] = [...PAINTED, 'image/avif']
/** Formats of images that are read at any precision. */
export const EXACT_IMAGES: readonly ImageType[] = [...PAINTED, 'image/tiff']

/** An image that may be decoded: its header says that it is small enough. */
export interface OpenedImage extends Pick<Metadata, 'channels' | 'depth'> {
  /** To be decoded once; colour profiles are ignored, and what is cut off is an error. */
  image: Sharp
  type: ImageType
  width: number
  height: number
  decodedBytes: number
}

/**
 * Reads the header of an image.
 *
 * @param name of the image, for errors.
 * @param types the formats that are allowed, known by their first bytes.
 * @throws FurrowError when it is in another format, damaged, longer than 8192 texels on a side, or would take too much
 *   memory.
 */
export async function openImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types: readonly ImageType[] = GLTF_IMAGES,
): Promise<OpenedImage> {
  const hints = { limit: listText(types.map((type) => FORMATS[type])), remedy: 'save it as PNG' }
  const type = typeOf(bytes)
  if (type === undefined || !types.includes(type)) {
    const kind = kindOf(bytes)
    const isImage = kind === undefined || kind === 'an image'
    const reason = isImage ? 'unsupported image format' : `it is ${kind}`
    const remedy = isImage ? hints.remedy : 'name an image'
    throw cannotRead(who, `the image ${name}`, new Error(reason), { ...hints, remedy })
  }
  const damage = imageDamage(bytes)
  if (damage) throw cannotRead(who, `the image ${name}`, new Error(damage), { ...hints, remedy: REPAIR })
  const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
  const { width, height, channels, depth } = await withImageErrors(name, who, () => image.metadata(), {
    limit: hints.limit,
  })
  if (width > MAX_IMAGE_SIDE || height > MAX_IMAGE_SIDE) {
    throw new FurrowError({
      code: 'out-of-range',
      who,
      what: `${name} is too large`,
      value: `${width} x ${height}`,
      limit: `${MAX_IMAGE_SIDE} texels a side`,
      remedy: 'scale it down',
    })
  }
  const decodedBytes = width * height * channels * (DEPTH_BYTES[depth] ?? 8)
  checkDecodedBytes(decodedBytes, name, who)
  return { image, type, width, height, channels, depth, decodedBytes }
}

/** Bytes per channel by the name that libvips has for it; up to 8 for others. */
const DEPTH_BYTES: Record<string, number | undefined> = {
  uchar: 1,
  char: 1,
  ushort: 2,
  short: 2,
  uint: 4,
  int: 4,
  float: 4,
}

function typeOf(bytes: Uint8Array): ImageType | undefined {
  const head = Buffer.from(bytes.subarray(0, 4)).toString('latin1')
  if (head === 'II*\0' || head === 'MM\0*') return 'image/tiff'
  const type = imageTypeOf(bytes)
  return type !== undefined && type in FORMATS ? (type as ImageType) : undefined
}

/** `a, b or c`. */
function listText(items: readonly string[]): string {
  return items.join(', ').replace(/, ([^,]*)$/, ' or $1')
}
