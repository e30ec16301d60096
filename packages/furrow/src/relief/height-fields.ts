import type { ImageArray } from '../core/image-array.ts'

/** A wrinkle layer with a height map. */
export interface RaisedLayer {
  /** Slice that stores the layer's height map. */
  slice: number
  /** Height difference between black and white, in metres. */
  amplitude: number
  /** Slices that store the weights of the layer's areas of influence. */
  areas: readonly number[]
}

/** Image whose texels have the value 0 or 1. */
export interface Mask {
  width: number
  height: number
  data: Uint8Array
}

/** Value of a height map for undisplaced skin. */
const NEUTRAL = 127.5

/** Displacement of the skin by one layer, at each point of the texture, if all areas of the layer are fully active. */
export class HeightField {
  readonly width: number
  readonly height: number
  /** Height map, followed by its mipmaps. Mipmaps are computed on demand. */
  readonly #mipmaps: Gray[]
  readonly #metresPerGray: number
  readonly #weights: Gray | null

  /**
   * @param heights height maps, 127.5 = undisplaced skin.
   * @param areas weights, 0..255, one slice per area. Null if the weights are only on the GPU; all weights are then assumed to be 255.
   */
  constructor(
    { slice, amplitude, areas: slices }: RaisedLayer,
    heights: ImageArray,
    areas: ImageArray | null,
  ) {
    this.width = heights.width
    this.height = heights.height
    const first = slice * heights.width * heights.height
    const data = heights.data.subarray(first, first + heights.width * heights.height)
    this.#mipmaps = [{ width: heights.width, height: heights.height, data }]
    this.#metresPerGray = amplitude / 255
    this.#weights = areas && { ...areas, data: unite(areas, slices) }
  }

  /**
   * Adds the absolute displacement at each texel, in metres, to `sums`. The result is an upper bound, because the largest area weight around
   * the texel is used.
   */
  addReach(sums: Float32Array): void {
    const [{ width, height, data }] = this.#mipmaps
    const areas = this.#weights && { ...this.#weights, data: widen(this.#weights.data, this.#weights) }
    for (let y = 0; y < height; y++) {
      const row = areas ? areas.width * Math.floor(((y + 0.5) / height) * areas.height) : 0
      for (let x = 0; x < width; x++) {
        const weight = areas ? areas.data[row + Math.floor(((x + 0.5) / width) * areas.width)] : 255
        // Most texels are not covered by any area, so skipping them saves time.
        if (weight === 0) continue
        const i = x + y * width
        sums[i] += (weight / 255) * Math.abs(data[i] - NEUTRAL) * this.#metresPerGray
      }
    }
  }

  /**
   * Samples the displacement between texels, with bilinear filtering. Coordinates outside the texture repeat.
   *
   * @param x column in texels; texel centres are at integers.
   * @param y row in texels.
   * @param level mipmap level. Fractional levels interpolate between two mipmaps (trilinear filtering).
   * @returns displacement in metres, positive outwards.
   */
  between(x: number, y: number, level = 0): number {
    const weight = this.#weights ? this.#bilinear(x, y, this.#weights) / 255 : 1
    // Most points are not covered by any area, so skipping them saves time.
    if (weight === 0) return 0
    const finer = Math.floor(level)
    const gray = this.#bilinear(x, y, this.#mipmap(finer))
    const coarser = level === finer ? gray : this.#bilinear(x, y, this.#mipmap(finer + 1))
    return weight * (gray + (level - finer) * (coarser - gray) - NEUTRAL) * this.#metresPerGray
  }

  /** Samples an image bilinearly. `atX` and `atY` are in texels of the height map, even if the image has a different size. */
  #bilinear(atX: number, atY: number, { width, height, data }: Gray): number {
    const x = ((atX + 0.5) / this.width) * width - 0.5
    const y = ((atY + 0.5) / this.height) * height - 0.5
    const right = x - Math.floor(x)
    const down = y - Math.floor(y)
    const x0 = wrap(Math.floor(x), width)
    const y0 = width * wrap(Math.floor(y), height)
    const x1 = x0 + 1 === width ? 0 : x0 + 1
    const y1 = y0 + width === data.length ? 0 : y0 + width
    const above = data[x0 + y0] * (1 - right) + data[x1 + y0] * right
    const below = data[x0 + y1] * (1 - right) + data[x1 + y1] * right
    return above * (1 - down) + below * down
  }

  #mipmap(level: number): Gray {
    const found = this.#mipmaps[level]
    if (found) return found
    const finer = this.#mipmap(level - 1)
    const made = finer.width * finer.height > 1 ? halve(finer) : finer
    this.#mipmaps[level] = made
    return made
  }
}

interface Gray {
  width: number
  height: number
  data: Uint8Array
}

/** Computes the next mipmap. Each new texel is the mean of four texels. */
function halve({ width, height, data }: Gray): Gray {
  const half = { width: Math.max(width >> 1, 1), height: Math.max(height >> 1, 1) }
  const out = new Uint8Array(half.width * half.height)
  const [dx, dy] = [width > 1 ? 1 : 0, height > 1 ? width : 0]
  for (let y = 0; y < half.height; y++) {
    for (let x = 0; x < half.width; x++) {
      const i = 2 * (x + y * width)
      out[x + y * half.width] = (data[i] + data[i + dx] + data[i + dy] + data[i + dx + dy] + 2) >> 2
    }
  }
  return { ...half, data: out }
}

/**
 * Finds the texels that all layers together can displace by more than `metres`.
 *
 * @param fields height fields of the layers, with maps of one size.
 * @returns generator that yields between parts of the work, and returns a mask with 1 for these texels and their neighbours.
 */
export function* raisedTexels(fields: readonly HeightField[], metres: number): Generator<void, Mask> {
  const [{ width, height }] = fields
  const sums = new Float32Array(width * height)
  for (const field of fields) {
    field.addReach(sums)
    yield
  }
  const mask = new Uint8Array(sums.length)
  for (let i = 0; i < sums.length; i++) if (sums[i] > metres) mask[i] = 1
  return { width, height, data: widen(mask, { width, height }) }
}

/** Returns a mask with 1 for all texels that one of the areas covers, and for their neighbours. */
export function weightedTexels(areas: ImageArray, slices: readonly number[]): Mask {
  const weights = unite(areas, slices)
  const { width, height } = areas
  return {
    width,
    height,
    data: widen(
      weights.map((weight) => Number(weight > 0)),
      areas,
    ),
  }
}

function wrap(texel: number, size: number): number {
  return ((texel % size) + size) % size
}

/** Adds the weights of areas, clamped to 255. For areas that combine by `max`, the sum is an upper bound. */
function unite({ width, height, data }: ImageArray, slices: readonly number[]): Uint8Array {
  const sum = new Uint8ClampedArray(width * height)
  for (const slice of slices) {
    const first = slice * sum.length
    for (let i = 0; i < sum.length; i++) sum[i] += data[first + i]
  }
  return new Uint8Array(sum.buffer)
}

/** Replaces each texel by the maximum of the texel and its eight neighbours, because bilinear filtering reads neighbours. */
function widen(values: Uint8Array, { width, height }: { width: number; height: number }): Uint8Array {
  const rows = new Uint8Array(values.length)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = x + y * width
      rows[i] = Math.max(values[i], x > 0 ? values[i - 1] : 0, x < width - 1 ? values[i + 1] : 0)
    }
  }
  const wide = new Uint8Array(values.length)
  for (let i = 0; i < wide.length; i++) {
    const [above, below] = [i - width, i + width]
    wide[i] = Math.max(rows[i], above >= 0 ? rows[above] : 0, below < wide.length ? rows[below] : 0)
  }
  return wide
}
