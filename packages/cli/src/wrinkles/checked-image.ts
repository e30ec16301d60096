import { FurrowError } from 'furrow'
import sharp from 'sharp'
import { transparencyError, withImageErrors } from '../images/pixels.ts'
import type { FileImage } from './embed.ts'

/** The formats of images in glTF without extensions. */
const MIME_TYPES: Record<string, string | undefined> = { png: 'image/png', jpeg: 'image/jpeg' }

/** An image that was decoded as a whole and can go into a glTF file. */
export interface CheckedImage extends FileImage {
  width: number
  height: number
}

/**
 * Checks that a map can go into a glTF file as it is: PNG or JPEG, whole, opaque.
 *
 * @throws FurrowError naming the file.
 */
export async function checkMap(
  bytes: Uint8Array,
  name: string,
  path: string,
  who: string,
): Promise<CheckedImage> {
  const { format, width, height, opaque } = await withImageErrors(path, who, async () => {
    const image = sharp(bytes, { failOn: 'truncated' })
    const [metadata, stats] = [await image.metadata(), await image.stats()]
    return { ...metadata, opaque: stats.isOpaque }
  })
  const mimeType = MIME_TYPES[format]
  if (!mimeType) {
    throw new FurrowError({
      code: 'unreadable',
      who,
      what: `${path} has a format that glTF does not support`,
      value: format,
      limit: 'PNG or JPEG',
      remedy: 'save it as PNG',
    })
  }
  if (!opaque) throw transparencyError(path, who, 'flatten it onto the skin')
  return { name, mimeType, bytes, width, height }
}

/**
 * Scales a map to a square. Normals are filtered as vectors and normalised again.
 *
 * @returns the image itself when it already has that size, otherwise a new one (PNG).
 */
export async function scaleMap(
  image: CheckedImage,
  size: number,
  kind: 'normals' | 'values',
): Promise<CheckedImage> {
  if (image.width === size && image.height === size) return image
  const scaled = sharp(image.bytes, { ignoreIcc: true }).resize(size, size, {
    fit: 'fill',
    kernel: 'mitchell',
  })
  const { data, info } = await scaled.toColourspace('srgb').raw().toBuffer({ resolveWithObject: true })
  if (kind === 'normals') normalise(data, info.channels)
  const raw = { width: size, height: size, channels: info.channels }
  const bytes = await sharp(data, { raw }).png({ compressionLevel: 9 }).toBuffer()
  return { ...image, mimeType: 'image/png', bytes, width: size, height: size }
}

/** Throws FurrowError where maps of one kind differ in size, which they must not within one array. */
export function checkOneSize(images: readonly CheckedImage[], kind: string, who: string): void {
  const sizes = images.map(({ width, height }) => `${width} x ${height}`)
  if (new Set(sizes).size <= 1) return
  throw new FurrowError({
    who,
    what: `the ${kind} maps of the layers differ in size`,
    value: sizes.join(', '),
    limit: 'one size for all layers',
    remedy: 'scale them to one size',
  })
}

function normalise(data: Uint8Array, channels: number): void {
  for (let i = 0; i < data.length; i += channels) {
    const vector = [0, 1, 2].map((k) => (data[i + k] / 255) * 2 - 1)
    const length = Math.hypot(...vector) || 1
    for (const [k, value] of vector.entries()) data[i + k] = Math.round((value / length / 2 + 0.5) * 255)
  }
}
