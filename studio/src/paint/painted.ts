import type { GrayImage } from 'furrow'
import type { Rectangle } from '../document/sculpted.ts'

/** Square image that brushes change: weights of an area, or heights in whole steps. */
export type PaintedImage = Omit<GrayImage, 'data'> & { readonly data: Uint8Array | Int16Array }

/** Result of painting: the new image and its changed texels, if any. */
export interface Painted<Image extends PaintedImage = GrayImage> {
  image: Image
  dirty: Rectangle | undefined
}

/** Returns the smallest rectangle that contains two others. */
export function around(a: Rectangle, b: Rectangle): Rectangle {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)]
  const width = Math.max(a.x + a.width, b.x + b.width) - x
  return { x, y, width, height: Math.max(a.y + a.height, b.y + b.height) - y }
}

export class Bounds {
  readonly #width: number
  #left = Infinity
  #top = Infinity
  #right = -1
  #bottom = -1

  /** @param width image width, texels. */
  constructor(width: number) {
    this.#width = width
  }

  add(texel: number): void {
    const [x, y] = [texel % this.#width, Math.floor(texel / this.#width)]
    this.#left = Math.min(this.#left, x)
    this.#right = Math.max(this.#right, x)
    this.#top = Math.min(this.#top, y)
    this.#bottom = Math.max(this.#bottom, y)
  }

  get rectangle(): Rectangle | undefined {
    if (this.#right < 0) return undefined
    const [x, y] = [this.#left, this.#top]
    return { x, y, width: this.#right - x + 1, height: this.#bottom - y + 1 }
  }
}

/** Applies a coverage (0..1) to a weight (0..255), without rounding. */
export function covered(weight: number, coverage: number, mode: 'add' | 'remove'): number {
  return mode === 'add' ? weight + coverage * (255 - weight) : weight * (1 - coverage)
}

/**
 * Raises or lowers the weights of an area.
 *
 * @param coverage coverage of each texel, 0..1. At 1, the weight becomes 255 or 0.
 */
export function cover(
  { width, height, data }: GrayImage,
  coverage: ArrayLike<number>,
  mode: 'add' | 'remove',
): Painted {
  const bounds = new Bounds(width)
  const image = { width, height, data: data.slice() }
  for (let texel = 0; texel < data.length; texel++) {
    if (coverage[texel] === 0) continue
    image.data[texel] = Math.round(covered(data[texel], coverage[texel], mode))
    if (image.data[texel] !== data[texel]) bounds.add(texel)
  }
  return { image, dirty: bounds.rectangle }
}
