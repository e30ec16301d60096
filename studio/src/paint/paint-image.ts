import { FurrowError, type GrayImage, resampleGray } from 'furrow'
import { checkPaintable } from './paint-map.ts'
import { cover, type Painted } from './painted.ts'

/**
 * Adds an image to an area, or removes it, resampled to the area's size as packing resamples areas.
 *
 * @param weights in the layout of the texture, as `readArea` reads a file; 255 = fully covered.
 * @param opacity 0..1.
 * @throws FurrowError when the area cannot be painted, or the opacity is out of range.
 */
export function paintImage(
  image: GrayImage,
  weights: GrayImage,
  mode: 'add' | 'remove',
  opacity = 1,
): Painted {
  checkPaintable(image)
  if (!(opacity >= 0 && opacity <= 1)) {
    throw new FurrowError({
      code: 'out-of-range',
      who: 'Studio',
      what: 'opacity of an image',
      value: opacity,
      limit: '0 to 1',
      remedy: 'choose one in this range',
    })
  }
  const { data } = resampleGray(weights, image.width)
  return cover(
    image,
    Float32Array.from(data, (weight) => (opacity * weight) / 255),
    mode,
  )
}
