import { FurrowError, type GrayImage } from 'furrow'
import type { ImageType } from './check-image.ts'

/** Image with interleaved 8-bit channels. Row 0 is at the top. Two channels are gray and alpha. */
export interface Pixels {
  width: number
  height: number
  channels: 1 | 2 | 3 | 4
  data: Uint8Array
}

export interface DecodedImage extends Pixels {
  type: ImageType
}

export function isOpaque({ channels, data }: Pixels): boolean {
  if (channels === 1 || channels === 3) return true
  for (let i = channels - 1; i < data.length; i += channels) if (data[i] !== 255) return false
  return true
}

export function withoutAlpha(image: Pixels): Pixels {
  const { channels, data } = image
  if (channels === 1 || channels === 3) return image
  const kept = data.filter((_, i) => i % channels !== channels - 1)
  return { ...image, channels: channels === 2 ? 1 : 3, data: kept }
}

/** Converts to RGBA. Images without alpha get alpha 255. */
export function toRgba({ width, height, channels, data }: Pixels): Uint8Array {
  if (channels === 4) return data
  const rgba = new Uint8Array(4 * width * height).fill(255)
  for (let i = 0, from = 0; from < data.length; i += 4, from += channels) {
    for (let k = 0; k < 3; k++) rgba[i + k] = data[from + (channels === 3 ? k : 0)]
    if (channels === 2) rgba[i + 3] = data[from + 1]
  }
  return rgba
}

/**
 * Returns one channel of an image. Gray images have equal R, G and B, and images without alpha have alpha 255.
 *
 * @param channel 0 = R, 1 = G, 2 = B, 3 = A.
 */
export function channelOf(pixels: Pixels, channel: number): GrayImage {
  const { width, height, channels, data } = pixels
  const hasAlpha = channels === 2 || channels === 4
  const offset = channel === 3 ? channels - 1 : channels < 3 ? 0 : channel
  const gray = new Uint8Array(width * height).fill(255)
  if (channel === 3 && !hasAlpha) return { width, height, data: gray }
  for (let i = 0; i < gray.length; i++) gray[i] = data[channels * i + offset]
  return { width, height, data: gray }
}

export function transparencyError(path: string, who: string, remedy: string): FurrowError {
  return new FurrowError({
    who,
    problem: `${path} has transparent texels`,
    limit: 'alpha 255 throughout',
    remedy,
  })
}
