import { FurrowError } from './error.ts'
import { MAX_IMAGE_SIDE } from './limits.ts'
import type { GrayImage, RgbaImage } from './types.ts'

const CHANNELS_OF = { gray: 1, RGBA: 4 } as const

/**
 * Checks that an image holds what it says.
 *
 * @throws FurrowError when a side is not a whole number from 1 to 8192, or the data has another length than
 *   width x height x channels (1 for gray, 4 for RGBA).
 */
export function checkImage(
  image: GrayImage | RgbaImage,
  layout: keyof typeof CHANNELS_OF,
  who: string,
): void {
  for (const side of [image.width, image.height]) {
    if (!Number.isInteger(side) || side < 1 || side > MAX_IMAGE_SIDE) {
      throw new FurrowError({
        code: 'out-of-range',
        who,
        what: 'image side out of range',
        value: `${image.width} x ${image.height}`,
        limit: `1 to ${MAX_IMAGE_SIDE} texels`,
        remedy: 'scale the image',
      })
    }
  }
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
 * Resamples a gray image to a square of `size` texels: bilinear where it grows, a triangle filter as wide as
 * the old texels' footprint where it shrinks, so that thin features are averaged and not skipped.
 *
 * @returns the image itself when it has that size already, else a new one.
 */
export function resampleGray(image: GrayImage, size: number): GrayImage {
  if (image.width === size && image.height === size) return image
  const columns = filterTaps(image.width, size)
  const rows = filterTaps(image.height, size)
  const wide = new Float64Array(image.height * size)
  for (let y = 0; y < image.height; y++) {
    for (let x = 0; x < size; x++) {
      wide[y * size + x] = weigh(columns[x], (i) => image.data[y * image.width + i])
    }
  }
  const data = new Uint8Array(size * size)
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      data[y * size + x] = Math.round(weigh(rows[y], (i) => wide[i * size + x]))
    }
  }
  return { width: size, height: size, data }
}

/** Which old texels make a new one, and how much of each; the weights add up to 1. */
interface Taps {
  first: number
  weights: number[]
}

/** Triangle filter centred on each new texel, at least one old texel wide; edges are clamped. */
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

function weigh(taps: Taps, at: (i: number) => number): number {
  let sum = 0
  for (let k = 0; k < taps.weights.length; k++) sum += taps.weights[k] * at(taps.first + k)
  return sum
}
