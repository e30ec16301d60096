import { FurrowError } from 'furrow'
import sharp from 'sharp'
import { withImageErrors } from '../images/image-errors.ts'
import { openImage } from '../images/open-image.ts'
import { transparencyError } from '../images/pixels.ts'
import type { FileImage } from './embed.ts'

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
  const { image, type, width, height } = await openImage(bytes, path, who, ['image/png', 'image/jpeg'])
  const { isOpaque } = await withImageErrors(path, who, () => image.stats())
  if (!isOpaque) throw transparencyError(path, who, 'flatten it onto the skin')
  return { name, mimeType: type, bytes, width, height }
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
