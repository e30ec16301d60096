import { wrongArgument } from './argument.ts'
import { FurrowError } from './error.ts'
import { MAX_IMAGE_SIDE } from './limits.ts'
import type { GrayImage, RgbaImage } from './types.ts'

const CHANNELS_OF = { gray: 1, RGBA: 4 } as const

/**
 * Checks an image's size and the length of its data.
 *
 * @throws FurrowError if the width or height is not an integer from 1 to 8192, or if the data does not have
 *   `width * height * channels` bytes (1 channel for gray, 4 for RGBA).
 */
export function checkImage(
  image: GrayImage | RgbaImage,
  layout: keyof typeof CHANNELS_OF,
  who: string,
): void {
  checkSides(image.width, image.height, who)
  if (!ArrayBuffer.isView(image.data)) throw wrongArgument(who, 'image data', image.data, 'a Uint8Array')
  const expected = image.width * image.height * CHANNELS_OF[layout]
  if (image.data.length !== expected) {
    throw new FurrowError({
      who,
      problem: `wrong length of ${layout} image data`,
      value: `${image.data.length} bytes`,
      limit: `${expected} bytes for ${image.width} x ${image.height}`,
      remedy: 'pass one byte per texel and channel',
    })
  }
}

function checkSides(width: number, height: number, who: string): void {
  for (const side of [width, height]) {
    if (Number.isInteger(side) && side >= 1 && side <= MAX_IMAGE_SIDE) continue
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'image size out of range',
      value: `${width} x ${height}`,
      limit: `1 to ${MAX_IMAGE_SIDE} texels`,
      remedy: 'resize the image',
    })
  }
}

/**
 * Resamples a gray image to a square. Enlarging is bilinear. Shrinking uses a triangle filter with a radius of one texel of the square.
 *
 * @param size width and height of the square in texels.
 * @returns `image` if it has this size already, otherwise a new image.
 */
export function resampleGray(image: GrayImage, size: number): GrayImage {
  const { width, height, data } = image
  if (width === size && height === size) return image
  const rows = resample(data, width, height, size, size)
  return { width: size, height: size, data: Uint8Array.from(rows, Math.round) }
}

/** Returns the value of the texel at texture coordinates. Beyond the image, it is that of the nearest texel. */
export function texelAt({ width, height, data }: GrayImage, [u, v]: readonly [u: number, v: number]): number {
  const index = (at: number, side: number) => Math.min(side - 1, Math.max(0, Math.floor(at * side)))
  return data[index(v, height) * width + index(u, width)]
}

/** Resamples values like `resampleGray`, without rounding. */
export function resample(
  data: ArrayLike<number>,
  width: number,
  height: number,
  newWidth: number,
  newHeight: number,
): Float64Array {
  return resampleTransposed(resampleTransposed(data, width, height, newWidth), height, newWidth, newHeight)
}

/**
 * Resamples the rows of an image to `size` texels and transposes the result. A second call resamples the columns and transposes back.
 * The filter radius is at least one source texel. Near the borders, the average is over the texels inside the image.
 */
function resampleTransposed(
  data: ArrayLike<number>,
  width: number,
  height: number,
  size: number,
): Float64Array {
  const columns = new Float64Array(size * height)
  const scale = width / size
  const radius = Math.max(scale, 1)
  for (let x = 0; x < size; x++) {
    const centre = (x + 0.5) * scale - 0.5
    const first = Math.max(0, Math.ceil(centre - radius))
    const last = Math.min(width - 1, Math.floor(centre + radius))
    for (let y = 0; y < height; y++) {
      let sum = 0
      let total = 0
      for (let k = first; k <= last; k++) {
        const weight = 1 - Math.abs(k - centre) / radius
        sum += weight * data[y * width + k]
        total += weight
      }
      columns[x * height + y] = sum / total
    }
  }
  return columns
}
