import type { GrayImage } from 'furrow'
import type { HeightMap, NormalMap, RgbaImage } from 'furrow/author'
import sharp, { type Sharp } from 'sharp'
import { paintedArea } from './painted-area.ts'
import type { Pixels } from './pixels.ts'

/** Steps per millimetre of a 16-bit height image, and the value of 0 mm. */
export const HEIGHT_STEPS_PER_MM = 1000
export const HEIGHT_ZERO = 32768
/** Maximum height in both directions, millimetres. */
export const MAX_HEIGHT = (65535 - HEIGHT_ZERO) / HEIGHT_STEPS_PER_MM

const PNG = { compressionLevel: 9 } as const
/** PNG options for maps of lines. Adaptive filters make slopes a third smaller; level 9 is three times slower for 4%. */
const MAP_PNG = { compressionLevel: 7, adaptiveFiltering: true } as const

/** Encodes pixels as PNG with the same channels. */
export function encodePng(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(PNG).toBuffer()
}

/** Encodes a map of lines like `encodePng`, but smaller. */
export function encodeMap(pixels: Pixels): Promise<Uint8Array> {
  return rawImage(pixels).png(MAP_PNG).toBuffer()
}

function rawImage({ width, height, channels, data }: Pixels): Sharp {
  const image = sharp(data, { raw: { width, height, channels } })
  return channels === 1 ? image.toColourspace('b-w') : image
}

/** Encodes pixels as PNG, without alpha if all texels are opaque. */
export function encodePngWithoutOpaqueAlpha(pixels: Pixels): Promise<Uint8Array> {
  const isOpaque = pixels.channels === 4 && pixels.data.every((value, i) => i % 4 !== 3 || value === 255)
  return isOpaque ? encodeRgb({ ...pixels, channels: 4 }) : encodePng(pixels)
}

/** Encodes RGBA pixels as RGB PNG, ignoring alpha. */
export function encodeRgb({ width, height, data }: Pixels & { channels: 4 }): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(PNG)
    .toBuffer()
}

/** Encodes a height map as 16-bit gray PNG: 32768 = 0 mm, 1000 steps per millimetre, clamped. */
export function encodeHeight({ width, height, data }: HeightMap): Promise<Uint8Array> {
  const steps = Uint16Array.from(data, (mm) => {
    return Math.min(Math.max(Math.round(mm * HEIGHT_STEPS_PER_MM) + HEIGHT_ZERO, 0), 65535)
  })
  return sharp(steps, { raw: { width, height, channels: 1 } })
    .toColourspace('grey16')
    .png(PNG)
    .toBuffer()
}

/** Encodes a normal map as RGB PNG, with 8 or 16 bits like its data. */
export function encodeNormalMap({ width, height, data }: NormalMap): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 3 } })
    .toColourspace(data instanceof Uint16Array ? 'rgb16' : 'srgb')
    .png(PNG)
    .toBuffer()
}

/** Encodes an RGBA normal map as 8-bit RGB PNG, ignoring alpha. */
export function encodeRgbaNormalMap({ width, height, data }: RgbaImage): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png(MAP_PNG)
    .toBuffer()
}

/** Encodes the weights of an area as 8-bit gray PNG in the paper's convention: black = visible. */
export function encodeArea(area: GrayImage): Promise<Uint8Array> {
  return encodePng(paintedArea(area))
}
