import { FurrowError } from 'furrow'
import { imageDamage, imageTypeOf, MAX_IMAGE_SIDE } from 'furrow/internal'
import { latin1 } from '../base/bytes.ts'
import { cannotRead } from '../base/errors.ts'
import { kindOf } from '../base/file-kind.ts'
import { checkDecodedBytes } from './decoded-bytes.ts'
import { REPAIR } from './image-errors.ts'

const FORMATS = {
  'image/png': 'PNG',
  'image/jpeg': 'JPEG',
  'image/webp': 'WebP',
  'image/avif': 'AVIF',
  'image/tiff': 'TIFF',
} as const

export type ImageType = keyof typeof FORMATS

const PAINTED: readonly ImageType[] = ['image/png', 'image/jpeg', 'image/webp']
export const GLTF_IMAGES: readonly ImageType[] = [...PAINTED, 'image/avif']
/** Allowed formats for height maps, and for images that become layers of a texture array. */
export const EXACT_IMAGES: readonly ImageType[] = [...PAINTED, 'image/tiff']

/** Properties of an image that are known before decoding. */
export interface ImageHeader {
  type: ImageType
  width: number
  height: number
  decodedBytes: number
}

/**
 * Recognises the format of an image by its first bytes, before a decoder reads it.
 *
 * @param name name of the image, for errors.
 * @param types allowed formats.
 * @throws FurrowError if the image has another format, or is damaged.
 */
export function checkImageType(
  bytes: Uint8Array,
  name: string,
  who: string,
  types: readonly ImageType[],
): ImageType {
  const hints = { limit: formatNames(types), remedy: 'save it as PNG' }
  const type = typeOf(bytes)
  if (type === undefined || !types.includes(type)) {
    const kind = kindOf(bytes)
    const isImage = kind === undefined || kind === 'an image'
    const reason = isImage ? 'unsupported image format' : `it is ${kind}`
    const remedy = isImage ? hints.remedy : 'choose an image'
    throw cannotRead(who, `the image ${name}`, new Error(reason), { ...hints, remedy })
  }
  const damage = imageDamage(bytes)
  if (damage) throw cannotRead(who, `the image ${name}`, new Error(damage), { ...hints, remedy: REPAIR })
  return type
}

/** Throws if an image is larger than 8192 texels per side, or would take too much memory. */
export function checkImageSize(
  { width, height, decodedBytes }: Omit<ImageHeader, 'type'>,
  name: string,
  who: string,
): void {
  if (width > MAX_IMAGE_SIDE || height > MAX_IMAGE_SIDE) {
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: `${name} is too large`,
      value: `${width} x ${height}`,
      limit: `${MAX_IMAGE_SIDE} texels per side`,
      remedy: 'scale it down',
    })
  }
  checkDecodedBytes(decodedBytes, name, who)
}

export function formatNames(types: readonly ImageType[]): string {
  const names = types.map((type) => FORMATS[type]).join(', ')
  return names.replace(/, ([^,]*)$/, ' or $1')
}

function typeOf(bytes: Uint8Array): ImageType | undefined {
  const head = latin1(bytes.subarray(0, 4))
  if (head === 'II*\0' || head === 'MM\0*') return 'image/tiff'
  const type = imageTypeOf(bytes)
  return type !== undefined && type in FORMATS ? (type as ImageType) : undefined
}
