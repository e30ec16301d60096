import { FurrowError } from 'furrow'
import { length3 } from 'furrow/internal'
import { decodeImage } from '#images'
import { isOpaque, transparencyError, withoutAlpha } from '../images/pixels.ts'
import { encodePortablePng } from '../images/png.ts'
import { scaleImage } from '../images/scale.ts'
import type { FileImage } from './embed.ts'

/** Image that is allowed in a glTF file and decodes without errors. */
export interface CheckedImage extends FileImage {
  width: number
  height: number
}

/**
 * Checks a map for a glTF file: it must be PNG or JPEG, opaque, and decode without errors.
 *
 * @throws FurrowError that names the file.
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
 * Scales a map to a square. Normals are renormalised.
 *
 * @param size width and height of the result, texels.
 * @returns a new PNG image, or `image` itself if it already has this size.
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

/**
 * Checks that maps of one kind have equal sizes, because they become layers of one texture array. Throws FurrowError.
 */
export function checkOneSize(images: readonly CheckedImage[], kind: string, who: string): void {
  const sizes = images.map(({ width, height }) => `${width} x ${height}`)
  if (new Set(sizes).size <= 1) return
  throw new FurrowError({
    who,
    problem: `the ${kind} maps of the layers differ in size`,
    value: sizes.join(', '),
    limit: 'one size for all layers',
    remedy: 'scale the maps to one size',
  })
}

function normalise(data: Uint8Array, channels: number): void {
  for (let i = 0; i < data.length; i += channels) {
    const [x, y, z] = [0, 1, 2].map((k) => (data[i + k] / 255) * 2 - 1)
    // `Math.hypot` rounds differently in different browsers.
    const length = length3(x, y, z) || 1
    for (const [k, value] of [x, y, z].entries()) data[i + k] = Math.round((value / length / 2 + 0.5) * 255)
  }
}
