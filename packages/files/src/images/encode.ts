import type { GrayImage } from 'furrow'
import type { HeightMap, NormalMap, RgbaImage } from 'furrow/author'
import sharp, { type Sharp } from 'sharp'
import { heightSteps } from './height-steps.ts'
import { paintedArea } from './painted-area.ts'
import type { Pixels } from './pixels.ts'

const PNG = { compressionLevel: 9 } as const
/**
 * PNG options for maps that consist mostly of wrinkle lines. Adaptive filters make the files a third smaller.
 * Compression level 9 would save another 4%, but takes three times as long as level 7.
 */
const MAP_PNG = { compressionLevel: 7, adaptiveFiltering: true } as const

export function encodePng(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(PNG).toBuffer()
}

/** Encodes a map of wrinkle lines as PNG. Keeps all channels. The file is smaller than with `encodePng`. */
export function encodeMap(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(MAP_PNG).toBuffer()
}

function rawImage({ width, height, channels, data }: Pixels): Sharp {
  const image = sharp(data, { raw: { width, height, channels } })
  return channels === 1 ? image.toColourspace('b-w') : image
}

/** Encodes pixels as PNG. Removes alpha if all texels are opaque. */
export function encodePngWithoutOpaqueAlpha(pixels: Pixels): Promise<Uint8Array> {
  const isOpaque = pixels.channels === 4 && pixels.data.every((value, i) => i % 4 !== 3 || value === 255)
  return isOpaque ? encodeRgb({ ...pixels, channels: 4 }) : encodePng(pixels)
}

export function encodeRgb({ width, height, data }: Pixels & { channels: 4 }): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(PNG)
    .toBuffer()
}

/** Encodes a height map as 16-bit gray PNG, see `HEIGHT_STEPS_PER_MM`. Clamps heights that the format cannot store. */
export function encodeHeight({ width, height, data }: HeightMap): Promise<Uint8Array> {
  return sharp(heightSteps(data), { raw: { width, height, channels: 1 } })
    .toColourspace('grey16')
    .png(PNG)
    .toBuffer()
}

/** Encodes a normal map as RGB PNG with the bit depth of its data, 8 or 16. */
export function encodeNormalMap({ width, height, data }: NormalMap): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 3 } })
    .toColourspace(data instanceof Uint16Array ? 'rgb16' : 'srgb')
    .png(PNG)
    .toBuffer()
}

/** Encodes an RGBA normal map as 8-bit RGB PNG. Drops alpha. */
export function encodeRgbaNormalMap({ width, height, data }: RgbaImage): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(MAP_PNG)
    .toBuffer()
}

/**
 * Encodes an area, i.e. one weight of the wrinkles per texel, as 8-bit gray PNG. Wrinkles are visible where the image
 * is black, as in the paper (Reis, De Martino and Batagelo 2008).
 */
export function encodeArea(area: GrayImage): Promise<Uint8Array> {
  return encodePng(paintedArea(area))
}
