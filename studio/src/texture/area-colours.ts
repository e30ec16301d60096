import type { GrayImage } from 'furrow'

/** Of an area over the skin, sRGB, and how opaque its full weight is. */
const COLOUR = [255, 122, 40] as const
const OPACITY = 0.8

/** An area as a picture to lay over the skin: RGBA, transparent where its weight is 0. */
export function colouredArea({ width, height, data }: GrayImage): ImageData {
  const picture = new ImageData(width, height)
  for (let i = 0; i < data.length; i++) {
    for (let k = 0; k < 3; k++) picture.data[4 * i + k] = COLOUR[k]
    picture.data[4 * i + 3] = OPACITY * data[i]
  }
  return picture
}
