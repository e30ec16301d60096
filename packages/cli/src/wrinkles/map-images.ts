import { FurrowError, type GrayImage } from 'furrow'
import sharp from 'sharp'
import { firstLine } from '../images.ts'
import type { FileImage } from './embed.ts'

/** Formats that glTF has without further extensions. */
const MIME_TYPES: Record<string, string | undefined> = { png: 'image/png', jpeg: 'image/jpeg' }

/** How many areas may share one image. */
export type Share = 1 | 3 | 4

/** Channels side by side, row 0 at the top. */
export interface Pixels {
  width: number
  height: number
  channels: 1 | 2 | 3 | 4
  data: Uint8Array
}

/** What is known of an image once it was decoded whole. */
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
  const { format, width, height, opaque } = await attempt(path, who, async () => {
    const image = sharp(bytes, { failOn: 'truncated' })
    const [metadata, stats] = [await image.metadata(), await image.stats()]
    return { ...metadata, opaque: stats.isOpaque }
  })
  const mimeType = MIME_TYPES[format]
  if (!mimeType) {
    throw new FurrowError({
      who,
      what: `${path} has a format that glTF does not have`,
      value: format,
      limit: 'PNG or JPEG',
      remedy: 'save it as PNG',
    })
  }
  if (!opaque) throw transparent(path, who, 'flatten it onto the skin')
  return { name, mimeType, bytes, width, height }
}

/**
 * Scales a map to a square. Normals are filtered as vectors and made as long as 1 again.
 *
 * @returns the image itself when it has that size already, else a new one (PNG).
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

function normalise(data: Uint8Array, channels: number): void {
  for (let i = 0; i < data.length; i += channels) {
    const vector = [0, 1, 2].map((k) => (data[i + k] / 255) * 2 - 1)
    const length = Math.hypot(...vector) || 1
    for (const [k, value] of vector.entries()) data[i + k] = Math.round((value / length / 2 + 0.5) * 255)
  }
}

/**
 * Decodes a painted area. Grays keep their value; colours count by their luma (ITU-R BT.601).
 *
 * @throws FurrowError when it is no image, cut off or transparent.
 */
export async function readGray(bytes: Uint8Array, path: string, who: string): Promise<GrayImage> {
  const { data, info, opaque } = await attempt(path, who, async () => {
    const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
    const { isOpaque } = await image.stats()
    const pixels = await image.toColourspace('srgb').removeAlpha().raw().toBuffer({ resolveWithObject: true })
    return { ...pixels, opaque: isOpaque }
  })
  if (!opaque) throw transparent(path, who, 'flatten it onto white')
  const { width, height, channels } = info
  if (channels === 1) return { width, height, data: new Uint8Array(data) }
  const gray = Uint8Array.from({ length: width * height }, (_, i) => {
    const [r, g, b] = data.subarray(channels * i, channels * i + 3)
    return Math.round(0.299 * r + 0.587 * g + 0.114 * b)
  })
  return { width, height, data: gray }
}

/** All channels of an image of a file, side by side as they are stored. */
export async function readPixels(bytes: Uint8Array, name: string, who: string): Promise<Pixels> {
  return attempt(name, who, async () => {
    const { data, info } = await sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
      .toColourspace('srgb')
      .raw()
      .toBuffer({ resolveWithObject: true })
    return { width: info.width, height: info.height, channels: info.channels, data: new Uint8Array(data) }
  })
}

/** As a PNG file: one channel as gray, four without alpha where that is 1 throughout. */
export async function encodePixels({ width, height, channels, data }: Pixels): Promise<Uint8Array> {
  let image = sharp(data, { raw: { width, height, channels } })
  if (channels === 1) image = image.toColourspace('b-w')
  if (channels === 4 && data.every((value, i) => i % 4 !== 3 || value === 255)) image = image.removeAlpha()
  return image.png({ compressionLevel: 9 }).toBuffer()
}

/** One channel, 0 = R to 3 = A, as glTF reads it: gray counts as R, G and B, and a missing alpha as 1. */
export function channelOf(pixels: Pixels, channel: number): GrayImage {
  const { width, height, channels, data } = pixels
  const alpha = channels === 2 || channels === 4
  const at = channel === 3 ? channels - 1 : channels < 3 ? 0 : channel
  const gray = new Uint8Array(width * height).fill(255)
  if (channel === 3 && !alpha) return { width, height, data: gray }
  for (let i = 0; i < gray.length; i++) gray[i] = data[channels * i + at]
  return { width, height, data: gray }
}

/** Areas of one size side by side, as the channels of one image; channels without an area are 0. */
export function interleave(weights: readonly GrayImage[], channels: number): Uint8Array {
  const data = new Uint8Array(channels * weights[0].data.length)
  for (const [k, area] of weights.entries()) {
    for (let i = 0; i < area.data.length; i++) data[channels * i + k] = area.data[i]
  }
  return data
}

/** Throws FurrowError where maps of one kind differ in size, as they may not within one array. */
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

/** Encodes areas of one size, so many to an image, as its channels in their order. */
export function shareImages(weights: readonly GrayImage[], share: Share): Promise<FileImage[]> {
  const groups = Array.from({ length: Math.ceil(weights.length / share) }, (_, i) => {
    return encodeShared(weights.slice(i * share, (i + 1) * share), `areas ${i + 1}`)
  })
  return Promise.all(groups)
}

/** Puts up to four areas of one size into the channels of one PNG; without a fourth there is no alpha. */
async function encodeShared(weights: readonly GrayImage[], name: string): Promise<FileImage> {
  const { width, height } = weights[0]
  const channels = weights.length === 1 ? 1 : weights.length === 4 ? 4 : 3
  const data = interleave(weights, channels)
  const image = sharp(data, { raw: { width, height, channels } })
  if (channels === 1) image.toColourspace('b-w')
  return { name, mimeType: 'image/png', bytes: await image.png({ compressionLevel: 9 }).toBuffer() }
}

async function attempt<T>(path: string, who: string, work: () => Promise<T>): Promise<T> {
  try {
    return await work()
  } catch (error) {
    throw new FurrowError({
      who,
      what: `${path} is not a readable image (${firstLine(error)})`,
      remedy: 'save it again as PNG; it may be cut off',
    })
  }
}

function transparent(path: string, who: string, remedy: string): FurrowError {
  return new FurrowError({
    who,
    what: `${path} has transparent texels`,
    limit: 'alpha 255 throughout',
    remedy,
  })
}
