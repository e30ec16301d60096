import type { ImageArray } from '../core/image-array.ts'

/** Layer with a height map. */
export interface RaisedLayer {
  /** Slice of the layer's height map. */
  slice: number
  /** Height difference from black to white, metres. */
  amplitude: number
  /** Slices of the layer's areas. */
  areas: readonly number[]
}

/** Image with a value of 1 (set) or 0 per texel. */
export interface Mask {
  width: number
  height: number
  data: Uint8Array
}

/** Gray of undisplaced skin. */
const NEUTRAL = 127.5

/** Displacement by one layer in texture space, if all areas of the layer are fully active. */
export class HeightField {
  readonly width: number
  readonly height: number
  /** Height map, followed by its mipmaps. Mipmaps are computed on demand. */
  readonly #mipmaps: Gray[]
  readonly #metresPerGray: number
  readonly #weights: Gray | null

  /**
   * @param heights height maps, 127.5 = undisplaced skin.
   * @param areas weights, one slice per area. Null if the weights are only on the GPU; they then count as 255 everywhere.
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

  /** Adds each texel's maximum displacement in either direction, metres. */
  addReach(sums: Float32Array): void {
    const [{ width, height, data }] = this.#mipmaps
    const areas = this.#weights && { ...this.#weights, data: widen(this.#weights.data, this.#weights) }
    for (let y = 0; y < height; y++) {
      const row = areas ? areas.width * Math.floor(((y + 0.5) / height) * areas.height) : 0
      for (let x = 0; x < width; x++) {
        const weight = areas ? areas.data[row + Math.floor(((x + 0.5) / width) * areas.width)] : 255
        // No area covers most of the texture.
        if (weight === 0) continue
        const i = x + y * width
        sums[i] += (weight / 255) * Math.abs(data[i] - NEUTRAL) * this.#metresPerGray
      }
    }
  }

  /**
   * Samples the outward displacement with bilinear filtering and repeated coordinates, metres. Texel centres are at integers.
   *
   * @param level mipmap level. Fractional levels interpolate between two mipmaps (trilinear filtering).
   */
  between(x: number, y: number, level = 0): number {
    const weight = this.#weights ? this.#bilinear(x, y, this.#weights) / 255 : 1
    // No area of the layer covers most of the skin.
    if (weight === 0) return 0
    const finer = Math.floor(level)
    const gray = this.#bilinear(x, y, this.#mipmap(finer))
    const coarser = level === finer ? gray : this.#bilinear(x, y, this.#mipmap(finer + 1))
    return weight * (gray + (level - finer) * (coarser - gray) - NEUTRAL) * this.#metresPerGray
  }

  /** Samples an image bilinearly. The coordinates are in texels of the height map, and the image may have another size. */
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

/** Computes the next mipmap: each texel is the mean of four. */
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

/** Finds the texels that all layers together can displace by more than `metres`. */
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

/** Finds the texels that any of some areas covers, regardless of heights. */
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

/** Adds the weights of some areas, clamped to 255. This is an upper bound for every `combine` mode. */
function unite({ width, height, data }: ImageArray, slices: readonly number[]): Uint8Array {
  const sum = new Uint8ClampedArray(width * height)
  for (const slice of slices) {
    const first = slice * sum.length
    for (let i = 0; i < sum.length; i++) sum[i] += data[first + i]
  }
  return new Uint8Array(sum.buffer)
}

/** Replaces each texel by the maximum of itself and its eight neighbours, because bilinear filtering reads neighbours. */
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
