import type { GrayImage } from 'furrow'
import { decodeImage } from '#images'
import { channelOf, isOpaque, transparencyError } from './pixels.ts'

/**
 * Decodes a painted area to gray. Converts colours to luma (ITU-R BT.601).
 *
 * @throws FurrowError like `decodeImage`, and if the image is transparent.
 */
export async function decodeGray(bytes: Uint8Array, path: string, who: string): Promise<GrayImage> {
  const image = await decodeImage(bytes, path, who)
  if (!isOpaque(image)) throw transparencyError(path, who, 'flatten it onto white')
  const { width, height, channels, data } = image
  if (channels < 3) return channelOf(image, 0)
  const gray = new Uint8Array(width * height)
  for (let i = 0, k = 0; i < gray.length; i++, k += channels) {
    gray[i] = Math.round(0.299 * data[k] + 0.587 * data[k + 1] + 0.114 * data[k + 2])
  }
  return { width, height, data: gray }
}
