import { FurrowError, MAX_IMAGE_SIDE } from 'furrow'
import sharp, { type Sharp } from 'sharp'
import { firstLine } from './images.ts'

/** A gray image with the precision of its file. */
export interface HeightImage {
  width: number
  height: number
  bits: 8 | 16
  /** 0 to 2^bits - 1 per texel. */
  data: Uint8Array | Uint16Array
}

/** Largest difference between the channels of a texel that still counts as gray, as a share of the full range. */
const GRAY_TOLERANCE = 0.02

/**
 * Reads heights from a gray 8-bit or 16-bit image (PNG, TIFF and what else sharp reads), value by value: colour
 * profiles are not applied, transparency is ignored.
 * Throws FurrowError where the file is no such image, is truncated, or is larger than 8192 texels a side.
 */
export async function readHeightImage(path: string, who: string): Promise<HeightImage> {
  const image = sharp(path, { ignoreIcc: true })
  const { width, height, depth } = await attempt(path, who, () => image.metadata())
  const refuse = (what: string, value: unknown, limit: string, remedy: string) =>
    new FurrowError({ who, what: `${what} ${path}`, value, limit, remedy })
  if (depth !== 'uchar' && depth !== 'ushort') {
    throw refuse('unusable depth of', depth, '8 or 16 bits per channel', 'save it as 16-bit gray PNG')
  }
  if (width > MAX_IMAGE_SIDE || height > MAX_IMAGE_SIDE) {
    throw refuse('too large a', `${width} x ${height}`, `${MAX_IMAGE_SIDE} texels a side`, 'scale it down')
  }
  const bits = depth === 'uchar' ? 8 : 16
  const { data, channels } = await attempt(path, who, () => pixels(image.removeAlpha(), bits))
  const full = 2 ** bits - 1
  if (channels === 1) return { width, height, bits, data }
  const gray = new (bits === 8 ? Uint8Array : Uint16Array)(width * height)
  for (let i = 0; i < gray.length; i++) {
    const [r, g, b] = [data[channels * i], data[channels * i + 1], data[channels * i + 2]]
    if (Math.max(r, g, b) - Math.min(r, g, b) > GRAY_TOLERANCE * full) {
      const at = `${r}, ${g}, ${b} at ${i % width}, ${Math.floor(i / width)}`
      throw refuse('colours in', at, 'gray heights', 'save the height map in gray; a normal map is none')
    }
    gray[i] = g
  }
  return { width, height, bits, data: gray }
}

async function pixels(image: Sharp, bits: 8 | 16) {
  // Without a 16-bit colour space sharp goes through 8 bits.
  const wide = bits === 16 ? image.toColourspace('rgb16') : image.toColourspace('srgb')
  const { data, info } = await wide
    .raw({ depth: bits === 16 ? 'ushort' : 'uchar' })
    .toBuffer({ resolveWithObject: true })
  const values = bits === 16 ? new Uint16Array(data.buffer, data.byteOffset, data.length / 2) : data
  return { data: values, channels: info.channels }
}

async function attempt<T>(path: string, who: string, work: () => Promise<T>): Promise<T> {
  try {
    return await work()
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot read the image ${path} (${firstLine(error)})`,
      limit: 'PNG or TIFF, 8 or 16 bits',
      remedy: 'check the path and the file',
    })
  }
}
