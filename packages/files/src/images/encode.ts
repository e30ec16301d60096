import type { GrayImage } from 'furrow'
import type { HeightMap, NormalMap, RgbaImage } from 'furrow/author'
import sharp, { type Sharp } from 'sharp'
import { paintedArea } from './painted-area.ts'
import type { Pixels } from './pixels.ts'

/** Steps of a 16-bit height image per millimetre, and the value of 0 mm. */
export const HEIGHT_STEPS_PER_MM = 1000
export const HEIGHT_ZERO = 32768
/** Largest distance from 0 mm in millimetres that fits in both directions. */
export const MAX_HEIGHT = (65535 - HEIGHT_ZERO) / HEIGHT_STEPS_PER_MM

const PNG = { compressionLevel: 9 } as const
/** For maps of lines. A filter for each row makes their slopes a third smaller; level 9 takes three times as long for 4% less. */
const MAP_PNG = { compressionLevel: 7, adaptiveFiltering: true } as const

/** Pixels as a PNG file with the same channels. */
export function encodePng(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(PNG).toBuffer()
}

/** A map of lines as `encodePng` does, smaller. */
export function encodeMap(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(MAP_PNG).toBuffer()
}

function rawImage({ width, height, channels, data }: Pixels): Sharp {
  const image = sharp(data, { raw: { width, height, channels } })
  return channels === 1 ? image.toColourspace('b-w') : image
}

/** Pixels as a PNG file, without alpha where it is 255 throughout. */
export function encodePngWithoutOpaqueAlpha(pixels: Pixels): Promise<Uint8Array> {
  const isOpaque = pixels.channels === 4 && pixels.data.every((value, i) => i % 4 !== 3 || value === 255)
  return isOpaque ? encodeRgb({ ...pixels, channels: 4 }) : encodePng(pixels)
}

/** RGBA pixels as an RGB PNG file; alpha is ignored. */
export function encodeRgb({ width, height, data }: Pixels & { channels: 4 }): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(PNG)
    .toBuffer()
}

/** A height map as a 16-bit gray PNG file: 32768 = 0 mm, 1000 steps per millimetre; clamped at its ends. */
export function encodeHeight({ width, height, data }: HeightMap): Promise<Uint8Array> {
  const steps = Uint16Array.from(data, (mm) => {
    return Math.min(Math.max(Math.round(mm * HEIGHT_STEPS_PER_MM) + HEIGHT_ZERO, 0), 65535)
  })
  return sharp(steps, { raw: { width, height, channels: 1 } })
    .toColourspace('grey16')
    .png(PNG)
    .toBuffer()
}

/** A normal map as an RGB PNG file of 8 or 16 bits, as its data has. */
export function encodeNormalMap({ width, height, data }: NormalMap): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 3 } })
    .toColourspace(data instanceof Uint16Array ? 'rgb16' : 'srgb')
    .png(PNG)
    .toBuffer()
}

/** A normal map in RGBA bytes as an 8-bit RGB PNG file; alpha is ignored. */
export function encodeRgbaNormalMap({ width, height, data }: RgbaImage): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(MAP_PNG)
    .toBuffer()
}

/** The weights of an area as an 8-bit gray PNG file in the paper's convention: white = no wrinkles. */
export function encodeArea(area: GrayImage): Promise<Uint8Array> {
  return encodePng(paintedArea(area))
}
