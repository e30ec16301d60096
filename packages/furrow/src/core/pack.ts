import { checkCount } from './check-areas.ts'
import { FurrowError } from './error.ts'
import { checkImage, resampleGray } from './image.ts'
import { type ImageArray, imageArray } from './image-array.ts'
import { DEFAULT_AREA_SIZE, MAX_AREAS } from './limits.ts'
import type { GrayImage, RgbaImage } from './types.ts'

/**
 * Packs RGBA images, such as the normal maps or base colours of all layers, into one array.
 *
 * @param images at least one image, all of the same size; copied.
 * @param who name of the caller in errors.
 * @throws FurrowError if there are no images, if an image is malformed, or if sizes differ.
 */
export function packColours(images: readonly RgbaImage[], who = 'packColours'): ImageArray {
  checkSizes(images, 'RGBA', who)
  return imageArray(images, 4)
}

/**
 * Packs single-channel maps, such as the roughness of all layers, into one array.
 *
 * @param images at least one image, all of the same size; copied.
 * @param who name of the caller in errors.
 * @throws FurrowError if there are no images, if an image is malformed, or if sizes differ.
 */
export function packGrays(images: readonly GrayImage[], who = 'packGrays'): ImageArray {
  checkSizes(images, 'gray', who)
  return imageArray(images, 1)
}

/**
 * Resamples the weights of areas of influence to squares of one size, and packs them into one single-channel array.
 *
 * @param weights 1 to 256 gray images of any size, 255 = wrinkles fully visible; copied.
 * @param size width and height of the squares in texels; default 128.
 * @param who name of the caller in errors.
 * @throws FurrowError if the number of images is out of range, or if an image is malformed.
 */
export function packAreas(
  weights: readonly GrayImage[],
  size = DEFAULT_AREA_SIZE,
  who = 'packAreas',
): ImageArray {
  checkCount(weights.length, 'areas', MAX_AREAS, who)
  const images = weights.map((image, index) => {
    checkImage(image, 'gray', `${who} area ${index}`)
    return resampleGray(image, size)
  })
  return imageArray(images, 1)
}

/** @throws FurrowError if there are no images, if an image is malformed, or if sizes differ. */
export function checkSizes(
  images: readonly (GrayImage | RgbaImage)[],
  layout: 'gray' | 'RGBA',
  who: string,
): void {
  if (images.length === 0) {
    throw new FurrowError({
      who,
      problem: 'no images',
      value: 0,
      limit: 'at least 1',
      remedy: 'pass an image',
    })
  }
  const { width, height } = images[0]
  for (const [index, image] of images.entries()) {
    checkImage(image, layout, `${who} image ${index}`)
    if (image.width === width && image.height === height) continue
    throw new FurrowError({
      who,
      problem: `image ${index} differs in size from image 0`,
      value: `${image.width} x ${image.height}`,
      limit: `${width} x ${height}`,
      remedy: 'scale all images of the array to one size',
    })
  }
}
