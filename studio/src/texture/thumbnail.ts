import type { GrayImage } from 'furrow'

/** Minimum weight that counts as a part of the area, 0..255. */
const MIN_WEIGHT = 32
/** Minimum width of the crop, as a fraction of the texture's width. */
const MIN_SIDE = 0.35
/** Width of the crop, as a multiple of the area's extent. */
const MARGIN = 1.3

/** Square part of a texture, as fractions of the texture's width. `side` is the width of the part. */
export interface Crop {
  x: number
  y: number
  side: number
}

/** Returns the part of the texture around an area, or the complete texture for an empty area. */
export function cropOf({ width, height, data }: GrayImage): Crop {
  let [left, top, right, bottom] = [width, height, 0, 0]
  for (let i = 0; i < data.length; i++) {
    if (data[i] < MIN_WEIGHT) continue
    const [x, y] = [i % width, Math.floor(i / width)]
    left = Math.min(left, x)
    right = Math.max(right, x + 1)
    top = Math.min(top, y)
    bottom = Math.max(bottom, y + 1)
  }
  if (right <= left) return { x: 0, y: 0, side: 1 }
  const extent = Math.max((right - left) / width, (bottom - top) / height)
  const side = Math.min(1, Math.max(MIN_SIDE, MARGIN * extent))
  const start = (low: number, high: number, size: number) =>
    Math.min(1 - side, Math.max(0, (low + high) / 2 / size - side / 2))
  return { x: start(left, right, width), y: start(top, bottom, height), side }
}

/** Downscales a part of an image by averaging the covered texels. */
export function shrink({ width, height, data }: GrayImage, { x, y, side }: Crop, size: number): GrayImage {
  const out = new Uint8Array(size * size)
  const range = (start: number, i: number, length: number): [number, number] => {
    const first = Math.min(length - 1, Math.floor((start + (i / size) * side) * length))
    return [
      first,
      Math.max(first + 1, Math.min(length, Math.floor((start + ((i + 1) / size) * side) * length))),
    ]
  }
  for (let row = 0; row < size; row++) {
    const [y0, y1] = range(y, row, height)
    for (let column = 0; column < size; column++) {
      const [x0, x1] = range(x, column, width)
      let sum = 0
      for (let v = y0; v < y1; v++) for (let u = x0; u < x1; u++) sum += data[v * width + u]
      out[row * size + column] = sum / ((x1 - x0) * (y1 - y0))
    }
  }
  return { width: size, height: size, data: out }
}
