import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import type { GrayImage } from './types.ts'

/**
 * Meaning of gray in the image of an area. Wrinkles are fully visible at black texels of a `paper` image, and at white texels of a
 * `weight` image. Areas in memory use `weight`. The `paper` convention is from C. D. G. Reis et al., "Real-time Simulation of Wrinkles",
 * WSCG 2008.
 */
export type AreaConvention = 'paper' | 'weight'

/**
 * Converts a painted gray image to the weights of an area (255 = fully visible).
 *
 * @param image gray, 8 bits per texel; not modified.
 * @param convention convention of the image; `paper` by default.
 * @param who name of the image in errors.
 * @returns a new image of the same size.
 * @throws FurrowError if the image is malformed, or only one texel wide or high.
 */
export function areaWeights(
  image: GrayImage,
  convention: AreaConvention = 'paper',
  who = 'areaWeights',
): GrayImage {
  checkImage(image, 'gray', who)
  if (image.width === 1 || image.height === 1) {
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'area image too small',
      value: `${image.width} x ${image.height}`,
      limit: 'at least 2 x 2 texels',
      remedy: 'paint the area in the UV layout of the mesh, e.g. at 128 x 128 texels',
    })
  }
  const data = convention === 'paper' ? image.data.map((value) => 255 - value) : image.data.slice()
  return { width: image.width, height: image.height, data }
}
