import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import type { GrayImage } from './types.ts'

/** `paper`: white = no wrinkles, black = fully visible. `weight`: the opposite, as in memory. */
export type AreaConvention = 'paper' | 'weight'

/**
 * Converts a painted gray image to the weights of an area (255 = fully visible).
 *
 * @param image painted gray, 8 bits; not modified.
 * @param convention how it was painted; `paper` by default.
 * @param who names the image in errors.
 * @returns a new image of the same size.
 * @throws FurrowError when the image is malformed, or only one texel wide or high: it cannot say where wrinkles are.
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
      problem: 'an area one texel wide or high cannot say where its wrinkles are',
      value: `${image.width} x ${image.height}`,
      limit: 'at least 2 x 2',
      remedy: 'paint it in the UV layout of the mesh, at 128 x 128 or so',
    })
  }
  const data = convention === 'paper' ? image.data.map((value) => 255 - value) : image.data.slice()
  return { width: image.width, height: image.height, data }
}
