import { wrongArgument } from './argument.ts'
import { FurrowError } from './error.ts'
import { MAX_IMAGE_SIDE } from './limits.ts'
import type { GrayImage, RgbaImage } from './types.ts'

const CHANNELS_OF = { gray: 1, RGBA: 4 } as const

/**
 * Checks an image's size and the length of its data.
 *
 * @throws FurrowError when a side is not an integer from 1 to 8192, or the data is not width x height x channels bytes long
 *   (1 channel for gray, 4 for RGBA).
 */
export function checkImage(
  image: GrayImage | RgbaImage,
  layout: keyof typeof CHANNELS_OF,
  who: string,
): void {
  checkSides(image.width, image.height, who)
  if (!ArrayBuffer.isView(image.data)) throw wrongArgument(who, 'data of an image', image.data, 'bytes')
  const expected = image.width * image.height * CHANNELS_OF[layout]
  if (image.data.length !== expected) {
    throw new FurrowError({
      who,
      what: `${layout} image data of the wrong length`,
      value: `${image.data.length} bytes`,
      limit: `${expected} bytes for ${image.width} x ${image.height}`,
      remedy: 'give one byte per texel and channel',
    })
  }
}

/**
 * Checks an image's size.
 *
 * @throws FurrowError when a side is not an integer from 1 to 8192.
 */
function checkSides(width: number, height: number, who: string): void {
  for (const side of [width, height]) {
    if (Number.isInteger(side) && side >= 1 && side <= MAX_IMAGE_SIDE) continue
    throw new FurrowError({
      code: 'out-of-range',
      who,
      what: 'image side out of range',
      value: `${width} x ${height}`,
      limit: `1 to ${MAX_IMAGE_SIDE} texels`,
      remedy: 'scale the image',
    })
  }
}

/**
 * Resamples a gray image to a square: bilinearly where it grows; where it shrinks by a triangle filter as wide as a new texel's
 * footprint, so that thin features are averaged instead of skipped.
 *
 * @param size side of the square in texels.
 * @returns the image itself if it has that size already, otherwise a new one.
 */
export function resampleGray(image: GrayImage, size: number): GrayImage {
  if (image.width === size && image.height === size) return image
  const columns = stretched(image.data, image.width, image.height, size)
  const rows = stretched(columns, image.height, size, size)
  const data = new Uint8Array(rows.map(Math.round))
  return { width: size, height: size, data }
}

/** The rows of an image at another width, as columns: twice, they are rows again. */
function stretched(data: ArrayLike<number>, width: number, height: number, size: number): Float64Array {
  const columns = new Float64Array(size * height)
  for (const [x, { first, weights }] of filterTaps(width, size).entries()) {
    for (let y = 0; y < height; y++) {
      let sum = 0
      for (let k = 0; k < weights.length; k++) sum += weights[k] * data[y * width + first + k]
      columns[x * height + y] = sum
    }
  }
  return columns
}

/** The consecutive source texels that make up a new one. */
interface Taps {
  first: number
  /** Sum to 1. */
  weights: number[]
}

/** Triangle filter centred on each new texel, with a radius of at least one source texel; edges are clamped. */
function filterTaps(from: number, to: number): Taps[] {
  const scale = from / to
  const radius = Math.max(scale, 1)
  return Array.from({ length: to }, (_, i) => {
    const centre = (i + 0.5) * scale - 0.5
    const first = Math.max(0, Math.ceil(centre - radius))
    const last = Math.min(from - 1, Math.floor(centre + radius))
    const weights: number[] = []
    for (let k = first; k <= last; k++) weights.push(Math.max(0, 1 - Math.abs(k - centre) / radius))
    const total = weights.reduce((sum, w) => sum + w, 0)
    return { first, weights: weights.map((w) => w / total) }
  })
}
