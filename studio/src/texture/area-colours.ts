import type { GrayImage } from 'furrow'

/** Colour in which areas are drawn over the skin, sRGB. */
const COLOUR = [255, 122, 40] as const
/** Opacity of this colour at full weight. */
const OPACITY = 0.8

/** Converts an area to an RGBA overlay, transparent at weight 0. */
export function colouredArea({ width, height, data }: GrayImage): ImageData {
  const picture = new ImageData(width, height)
  for (let i = 0; i < data.length; i++) {
    for (let k = 0; k < 3; k++) picture.data[4 * i + k] = COLOUR[k]
    picture.data[4 * i + 3] = OPACITY * data[i]
  }
  return picture
}
