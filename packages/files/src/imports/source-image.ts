import { decodeImage, measureImage } from '#images'
import { EXACT_IMAGES } from '../images/check-image.ts'
import { channelOf, type Pixels } from '../images/pixels.ts'
import { scaleImage } from '../images/scale.ts'
import type { SourceFiles } from './source-files.ts'
import { decodeTga } from './tga.ts'

const isTga = (path: string) => /\.tga$/i.test(path)

/**
 * Decodes an image of an export: PNG, JPEG, WebP, TIFF or TGA.
 *
 * @param size width and height of the result in texels. Default: the size of the image.
 * @throws FurrowError if the image is missing, damaged or too large.
 */
export async function readSourceImage(
  files: SourceFiles,
  path: string,
  who: string,
  size?: number,
): Promise<Pixels> {
  const bytes = await files.read(path)
  const image = isTga(path)
    ? await decodeTga(bytes, path, who)
    : await decodeImage(bytes, path, who, EXACT_IMAGES)
  return scaledTo(image, size)
}

/** Returns the larger side of an image in texels. Reads only its header, except for TGA. */
export async function sideOf(files: SourceFiles, path: string, who: string): Promise<number> {
  const bytes = await files.read(path)
  const { width, height } = isTga(path)
    ? await decodeTga(bytes, path, who)
    : await measureImage(bytes, path, who, EXACT_IMAGES)
  return Math.max(width, height)
}

export function scaledTo(image: Pixels, size: number | undefined): Pixels {
  if (size === undefined || (image.width === size && image.height === size)) return image
  return scaleImage(image, size)
}

/**
 * Returns the x, y and z of a normal map, three numbers from -1 to 1 per texel, not normalised.
 *
 * @param isGreenDown whether green points down, as in Direct3D. It points up in glTF.
 */
export function normalsOf({ width, height, channels, data }: Pixels, isGreenDown: boolean): Float32Array {
  const normals = new Float32Array(3 * width * height)
  for (let i = 0; i < width * height; i++) {
    for (let k = 0; k < 3; k++)
      normals[3 * i + k] = data[channels * i + Math.min(k, channels - 1)] / 127.5 - 1
    if (isGreenDown) normals[3 * i + 1] *= -1
  }
  return normals
}

/** Returns the colour of each texel, three bytes per texel. Gray images have equal bytes. */
export function coloursOf(image: Pixels): Uint8Array {
  const planes = [0, 1, 2].map((k) => channelOf(image, k).data)
  const colours = new Uint8Array(3 * planes[0].length)
  for (let i = 0; i < planes[0].length; i++) for (let k = 0; k < 3; k++) colours[3 * i + k] = planes[k][i]
  return colours
}
