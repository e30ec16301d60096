import type { CanvasPixels } from './read-canvas.ts'

/** Rectangle of a picture, in fractions of its width and height from the top left. */
export interface Region {
  left: number
  top: number
  right: number
  bottom: number
}

export const WHOLE: Region = { left: 0, top: 0, right: 1, bottom: 1 }

/** Forehead of the shipped face in the view `front`, and its chin, which has no wrinkles. */
export const FOREHEAD: Region = { left: 0.42, top: 0.18, right: 0.58, bottom: 0.34 }
export const CHIN: Region = { left: 0.42, top: 0.62, right: 0.58, bottom: 0.74 }

/** Returns the largest difference in any channel of two pictures of equal size within a region. */
export function largestDifference(a: CanvasPixels, b: CanvasPixels, region: Region): number {
  let largest = 0
  forEachByte(a, region, (i) => {
    largest = Math.max(largest, Math.abs(a.data[i] - b.data[i]))
  })
  return largest
}

/** Returns the mean difference over all channels of two pictures of equal size within a region. */
export function meanDifference(a: CanvasPixels, b: CanvasPixels, region: Region): number {
  let [sum, count] = [0, 0]
  forEachByte(a, region, (i) => {
    sum += Math.abs(a.data[i] - b.data[i])
    count++
  })
  return sum / count
}

/** Returns the difference of the brightest and the darkest byte: 0 for a blank picture. */
export function contrast(picture: CanvasPixels): number {
  let [low, high] = [255, 0]
  forEachByte(picture, WHOLE, (i) => {
    low = Math.min(low, picture.data[i])
    high = Math.max(high, picture.data[i])
  })
  return high - low
}

function forEachByte(
  { width, height }: CanvasPixels,
  { left, top, right, bottom }: Region,
  visit: (i: number) => void,
): void {
  for (let y = Math.floor(top * height); y < bottom * height; y++) {
    for (let x = Math.floor(left * width); x < right * width; x++) {
      for (let k = 0; k < 3; k++) visit((y * width + x) * 3 + k)
    }
  }
}
