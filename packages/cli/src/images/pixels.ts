import { FurrowError, type GrayImage } from 'furrow'
import sharp from 'sharp'
import { cannotRead } from '../errors.ts'

/** Interleaved channels in bytes, row 0 at the top. */
export interface Pixels {
  width: number
  height: number
  channels: 1 | 2 | 3 | 4
  data: Uint8Array
}

/**
 * Decodes an image with the channels that it has. Colour profiles are ignored.
 *
 * @param name of the image, for errors.
 * @throws FurrowError when it cannot be decoded, or is cut off.
 */
export async function decodePixels(bytes: Uint8Array, name: string, who: string): Promise<Pixels> {
  return withImageErrors(name, who, async () => {
    const { data, info } = await sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
      .toColourspace('srgb')
      .raw()
      .toBuffer({ resolveWithObject: true })
    return { width: info.width, height: info.height, channels: info.channels, data: new Uint8Array(data) }
  })
}

/**
 * Decodes a painted area. Grays keep their value; of colours it is the luma (ITU-R BT.601).
 *
 * @throws FurrowError when it cannot be decoded, is cut off or transparent.
 */
export async function decodeGray(bytes: Uint8Array, path: string, who: string): Promise<GrayImage> {
  const { data, info, opaque } = await withImageErrors(path, who, async () => {
    const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
    const { isOpaque } = await image.stats()
    const pixels = await image.toColourspace('srgb').removeAlpha().raw().toBuffer({ resolveWithObject: true })
    return { ...pixels, opaque: isOpaque }
  })
  if (!opaque) throw transparencyError(path, who, 'flatten it onto white')
  const { width, height, channels } = info
  if (channels === 1) return { width, height, data: new Uint8Array(data) }
  const gray = Uint8Array.from({ length: width * height }, (_, i) => {
    const [r, g, b] = data.subarray(channels * i, channels * i + 3)
    return Math.round(0.299 * r + 0.587 * g + 0.114 * b)
  })
  return { width, height, data: gray }
}

/** One channel, 0 = R to 3 = A, as glTF reads it: gray counts as R, G and B, and a missing alpha as 1. */
export function channelOf(pixels: Pixels, channel: number): GrayImage {
  const { width, height, channels, data } = pixels
  const hasAlpha = channels === 2 || channels === 4
  const offset = channel === 3 ? channels - 1 : channels < 3 ? 0 : channel
  const gray = new Uint8Array(width * height).fill(255)
  if (channel === 3 && !hasAlpha) return { width, height, data: gray }
  for (let i = 0; i < gray.length; i++) gray[i] = data[channels * i + offset]
  return { width, height, data: gray }
}

/** Runs the decoding of an image; what it throws becomes a FurrowError with these hints. */
export async function withImageErrors<T>(
  name: string,
  who: string,
  decode: () => Promise<T>,
  hints: { limit?: string; remedy?: string } = { remedy: 'save it again as PNG; it may be cut off' },
): Promise<T> {
  try {
    return await decode()
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotRead(who, `the image ${name}`, error, hints)
  }
}

/** The error for an image with alpha below 255 that must be opaque. */
export function transparencyError(path: string, who: string, remedy: string): FurrowError {
  return new FurrowError({
    who,
    what: `${path} has transparent texels`,
    limit: 'alpha 255 throughout',
    remedy,
  })
}
