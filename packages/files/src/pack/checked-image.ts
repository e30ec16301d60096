import { FurrowError } from 'furrow'
import { length3 } from 'furrow/internal'
import { decodeImage } from '#images'
import { isOpaque, transparencyError, withoutAlpha } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import { scaleImage } from '../images/scale.ts'
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
  const image = await decodeImage(bytes, path, who, ['image/png', 'image/jpeg'])
  if (!isOpaque(image)) throw transparencyError(path, who, 'flatten it onto the skin')
  return { name, mimeType: image.type, bytes, width: image.width, height: image.height }
}

/**
 * Scales a map to a square. Normals are filtered as vectors and normalised again.
 *
 * @param who for errors.
 * @returns the image itself when it already has that size, otherwise a new one (PNG).
 */
export async function scaleMap(
  image: CheckedImage,
  size: number,
  kind: 'normals' | 'values',
  who: string,
): Promise<CheckedImage> {
  if (image.width === size && image.height === size) return image
  const scaled = scaleImage(await decodeImage(image.bytes, image.name, who), size)
  if (kind === 'normals') normalise(scaled.data, scaled.channels)
  const bytes = encodePortablePng(withoutAlpha(scaled))
  return { ...image, mimeType: 'image/png', bytes, width: size, height: size }
}

/** Throws FurrowError where maps of one kind differ in size, which they must not within one array. */
export function checkOneSize(images: readonly CheckedImage[], kind: string, who: string): void {
  const sizes = images.map(({ width, height }) => `${width} x ${height}`)
  if (new Set(sizes).size <= 1) return
  throw new FurrowError({
    who,
    problem: `the ${kind} maps of the layers differ in size`,
    value: sizes.join(', '),
    limit: 'one size for all layers',
    remedy: 'scale them to one size',
  })
}

function normalise(data: Uint8Array, channels: number): void {
  for (let i = 0; i < data.length; i += channels) {
    const [x, y, z] = [0, 1, 2].map((k) => (data[i + k] / 255) * 2 - 1)
    // Browsers round `Math.hypot` differently.
    const length = length3(x, y, z) || 1
    for (const [k, value] of [x, y, z].entries()) data[i + k] = Math.round((value / length / 2 + 0.5) * 255)
  }
}
