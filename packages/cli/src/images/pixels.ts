import { FurrowError, type GrayImage } from 'furrow'
import { withImageErrors } from './image-errors.ts'
import { openImage } from './open-image.ts'

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
 * @throws FurrowError when it cannot be decoded, see `openImage`, or is cut off.
 */
export async function decodePixels(bytes: Uint8Array, name: string, who: string): Promise<Pixels> {
  const { image } = await openImage(bytes, name, who)
  const raw = image.toColourspace('srgb').raw()
  const { data, info } = await withImageErrors(name, who, () => raw.toBuffer({ resolveWithObject: true }))
  return { width: info.width, height: info.height, channels: info.channels, data }
}

/**
 * Decodes a painted area. Grays keep their value; of colours it is the luma (ITU-R BT.601).
 *
 * @throws FurrowError when it cannot be decoded, see `openImage`, is cut off or transparent.
 */
export async function decodeGray(bytes: Uint8Array, path: string, who: string): Promise<GrayImage> {
  const { image } = await openImage(bytes, path, who)
  const { data, info, opaque } = await withImageErrors(path, who, async () => {
    const { isOpaque } = await image.stats()
    const pixels = await image.toColourspace('srgb').removeAlpha().raw().toBuffer({ resolveWithObject: true })
    return { ...pixels, opaque: isOpaque }
  })
  if (!opaque) throw transparencyError(path, who, 'flatten it onto white')
  const { width, height, channels } = info
  if (channels === 1) return { width, height, data }
  const gray = new Uint8Array(width * height)
  for (let i = 0, k = 0; i < gray.length; i++, k += channels) {
    gray[i] = Math.round(0.299 * data[k] + 0.587 * data[k + 1] + 0.114 * data[k + 2])
  }
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

/** The error for an image with alpha below 255 that must be opaque. */
export function transparencyError(path: string, who: string, remedy: string): FurrowError {
  return new FurrowError({
    who,
    what: `${path} has transparent texels`,
    limit: 'alpha 255 throughout',
    remedy,
  })
}
