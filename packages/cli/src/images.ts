import { mkdir, rename, rm, writeFile } from 'node:fs/promises'
import { dirname } from 'node:path'
import { FurrowError } from 'furrow'
import type { GrayImage, HeightMap, RgbaImage } from 'furrow/author'
import sharp from 'sharp'

/** Steps of a 16-bit height image per millimetre, and the value that stands for 0 mm. */
export const HEIGHT_STEPS_PER_MM = 1000
export const HEIGHT_ZERO = 32768

/** A file's whole content, still in memory. */
export interface Output {
  path: string
  bytes: Uint8Array
}

/**
 * Decodes a normal map (any format sharp reads) into linear bytes with alpha 255; scaled to `size` x `size` texels
 * where that is given. `name` is used in errors. Throws FurrowError where the bytes are no image.
 */
export async function decodeNormalMap(bytes: Uint8Array, name: string, size?: number): Promise<RgbaImage> {
  try {
    let image = sharp(bytes).toColourspace('srgb').removeAlpha()
    if (size !== undefined) image = image.resize(size, size, { fit: 'fill', kernel: 'cubic' })
    const { data, info } = await image.raw().toBuffer({ resolveWithObject: true })
    const { width, height, channels } = info
    const rgba = new Uint8Array(4 * width * height).fill(255)
    for (let i = 0; i < width * height; i++) {
      for (let k = 0; k < 3; k++) rgba[4 * i + k] = data[channels * i + Math.min(k, channels - 1)]
    }
    return { width, height, data: rgba }
  } catch (error) {
    throw new FurrowError({
      who: 'furrow strokes',
      what: `the normal map ${name} is not a readable image (${firstLine(error)})`,
      remedy: 'give a PNG, JPEG or WebP file',
    })
  }
}

/** The height map as a 16-bit gray PNG: 32768 = 0 mm, 1000 steps per millimetre. */
export async function encodeHeight(relief: HeightMap): Promise<Uint8Array> {
  const { width, height, data } = relief
  const steps = Uint16Array.from(data, (mm) => {
    return Math.min(Math.max(Math.round(mm * HEIGHT_STEPS_PER_MM) + HEIGHT_ZERO, 0), 65535)
  })
  return sharp(steps, { raw: { width, height, channels: 1 } })
    .toColourspace('grey16')
    .png({ compressionLevel: 9 })
    .toBuffer()
}

/** A normal map as an 8-bit RGB PNG. */
export async function encodeNormal({ width, height, data }: RgbaImage): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 4 } })
    .removeAlpha()
    .png({ compressionLevel: 9, adaptiveFiltering: true })
    .toBuffer()
}

/** An area as an 8-bit gray PNG in the paper's convention: weights turned round, white = no wrinkles. */
export async function encodeArea({ width, height, data }: GrayImage): Promise<Uint8Array> {
  const paper = data.map((weight) => 255 - weight)
  return sharp(paper, { raw: { width, height, channels: 1 } })
    .toColourspace('b-w')
    .png({ compressionLevel: 9 })
    .toBuffer()
}

/**
 * Writes all files or none: everything goes to temporary files beside their targets first, then they are renamed.
 * Missing folders are made. Throws FurrowError naming the file that cannot be written.
 */
export async function writeAll(outputs: readonly Output[], who = 'furrow strokes'): Promise<void> {
  const temporary = (path: string) => `${path}.${process.pid}.tmp`
  let current = ''
  try {
    for (const { path, bytes } of outputs) {
      current = path
      await mkdir(dirname(path), { recursive: true })
      await writeFile(temporary(path), bytes)
    }
    for (const { path } of outputs) {
      current = path
      await rename(temporary(path), path)
    }
  } catch (error) {
    await Promise.all(outputs.map(({ path }) => rm(temporary(path), { force: true }).catch(() => {})))
    throw new FurrowError({
      who,
      what: `cannot write ${current} (${firstLine(error)})`,
      remedy: 'check the folder and its permissions',
    })
  }
}

/** The first line of whatever was thrown: libraries add stacks and hints that do not fit one line. */
export function firstLine(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).split('\n')[0].trim()
}
