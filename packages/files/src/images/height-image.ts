import { FurrowError } from 'furrow'
import type { Sharp } from 'sharp'
import { readBytes } from '../disk/read-bytes.ts'
import { EXACT_IMAGES } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'

/** Gray image with the bit depth of its file. */
export interface HeightImage {
  width: number
  height: number
  bits: 8 | 16
  /** Values, `0` to `2 ** bits - 1`. */
  data: Uint8Array | Uint16Array
}

/** Maximum difference between the channels of a gray texel, as a fraction of the largest value of a channel. */
const GRAY_TOLERANCE = 0.02

const HINTS = { limit: 'PNG or TIFF, 8 or 16 bits', remedy: 'check the path and the file' }

/**
 * Reads a gray height map with 8 or 16 bits (PNG, TIFF, JPEG or WebP). Ignores colour profiles and transparency.
 *
 * @throws FurrowError if the file has another format, is truncated, has colours, or is larger than 8192 texels per
 *   side.
 */
export async function readHeightImage(path: string, who: string): Promise<HeightImage> {
  const bytes = await readBytes(path, who, 'the image')
  const opened = await openImage(bytes, path, who, EXACT_IMAGES)
  const { image, width, height, depth } = opened
  if (depth !== 'uchar' && depth !== 'ushort') {
    throw new FurrowError({
      who,
      problem: `unsupported bit depth of ${path}`,
      value: depth,
      limit: '8 or 16 bits per channel',
      remedy: 'save it as 16-bit gray PNG',
    })
  }
  const bits = depth === 'uchar' ? 8 : 16
  const decode = () => readPixels(image.removeAlpha(), bits, opened.channels < 3)
  const { data, channels } = await withImageErrors(path, who, decode, HINTS)
  const full = bits === 8 ? 0xff : 0xffff
  if (channels === 1) return { width, height, bits, data }
  const gray = new (bits === 8 ? Uint8Array : Uint16Array)(width * height)
  for (let i = 0; i < gray.length; i++) {
    const [r, g, b] = [data[channels * i], data[channels * i + 1], data[channels * i + 2]]
    if (Math.max(r, g, b) - Math.min(r, g, b) > GRAY_TOLERANCE * full) {
      throw new FurrowError({
        who,
        problem: `${path} has colours`,
        value: `${r}, ${g}, ${b} at ${i % width}, ${Math.floor(i / width)}`,
        limit: 'gray heights',
        remedy: 'save the height map in gray; a normal map is not a height map',
      })
    }
    gray[i] = g
  }
  return { width, height, bits, data: gray }
}

async function readPixels(image: Sharp, bits: 8 | 16, isGray: boolean) {
  // In the default colour space, sharp would reduce 16-bit values to 8 bits.
  const space = bits === 16 ? (isGray ? 'grey16' : 'rgb16') : isGray ? 'b-w' : 'srgb'
  const { data, info } = await image
    .toColourspace(space)
    .raw({ depth: bits === 16 ? 'ushort' : 'uchar' })
    .toBuffer({ resolveWithObject: true })
  const values = bits === 16 ? new Uint16Array(data.buffer, data.byteOffset, data.length / 2) : data
  return { data: values, channels: info.channels }
}
