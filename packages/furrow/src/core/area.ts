import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import type { GrayImage } from './types.ts'

/** `paper`: white = no wrinkles, black = fully visible. `weight`: the other way round, as in memory. */
export type AreaConvention = 'paper' | 'weight'

/**
 * Turns a painted gray image into the weights an area holds in memory (255 = fully visible).
 *
 * @param image painted gray, 8 bits; not modified.
 * @param convention how it was painted; the paper's unless told.
 * @throws FurrowError when the image is malformed, or a single texel, which cannot say where wrinkles lie.
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
      what: 'an area one texel wide cannot say where its wrinkles lie',
      value: `${image.width} x ${image.height}`,
      limit: 'at least 2 x 2',
      remedy: 'paint it in the UV layout of the mesh, at 128 x 128 or so',
    })
  }
  const data = convention === 'paper' ? image.data.map((value) => 255 - value) : image.data.slice()
  return { width: image.width, height: image.height, data }
}
