import { Color, type DataArrayTexture, LinearMipmapLinearFilter, MathUtils, SRGBColorSpace } from 'three'
import type { Bounds } from '../../core/bounds.ts'

/** One mipmap level of one slice of a texture array. */
export interface MipLevel {
  readonly width: number
  readonly height: number
  readonly data: Uint8Array
}

/** Returns the first mipmap level of a slice. Its `data` is a view of the texture's data. */
export function firstLevel(texture: DataArrayTexture, slice: number): MipLevel {
  const { data, width, height, depth } = texture.image as MipLevel & { depth: number }
  const bytes = data.length / depth
  return { width, height, data: data.subarray(slice * bytes, (slice + 1) * bytes) }
}

/** Returns the number of channels per texel. Each channel is one byte. */
export function channelsOf({ width, height, data }: MipLevel): number {
  return data.length / (width * height)
}

/**
 * Mipmaps of one slice of a texture array, computed on the CPU, so that a change of a few texels updates only a few texels per level. Each
 * texel is the mean of four texels of the previous level, in linear colour. GPUs compute the same mean if width and height are powers of two.
 * For other sizes, the result depends on the GPU. For other sizes or without mipmaps, `levels` contains only the first level.
 */
export class MipChain {
  readonly levels: readonly MipLevel[]
  readonly #isColour: boolean

  constructor(texture: DataArrayTexture, slice: number) {
    const first = firstLevel(texture, slice)
    const { width, height } = first
    this.#isColour = texture.colorSpace === SRGBColorSpace
    const isMapped = texture.minFilter === LinearMipmapLinearFilter
    const isHalved = isMapped && MathUtils.isPowerOfTwo(width) && MathUtils.isPowerOfTwo(height)
    this.levels = isHalved ? [first, ...smallerLevels(first)] : [first]
    this.update({ x0: 0, y0: 0, x1: width, y1: height })
  }

  /**
   * Updates all levels after a change in a rectangle of the first level.
   *
   * @returns the changed rectangle per level.
   */
  update(bounds: Bounds): Bounds[] {
    const touched = [bounds]
    for (let i = 1; i < this.levels.length; i++) {
      const { x0, y0, x1, y1 } = touched[i - 1]
      const half = { x0: x0 >> 1, y0: y0 >> 1, x1: (x1 + 1) >> 1, y1: (y1 + 1) >> 1 }
      this.#halve(this.levels[i - 1], this.levels[i], half)
      touched.push(half)
    }
    return touched
  }

  /** Computes the texels in a rectangle of the level `to` as means of texels of the level `from`. */
  #halve(from: MipLevel, to: MipLevel, { x0, y0, x1, y1 }: Bounds): void {
    const channels = channelsOf(from)
    const colours = this.#isColour ? colourTables() : null
    for (let y = y0; y < y1; y++) {
      const top = 2 * y * from.width
      const bottom = Math.min(2 * y + 1, from.height - 1) * from.width
      for (let x = x0; x < x1; x++) {
        const left = 2 * x
        const right = Math.min(2 * x + 1, from.width - 1)
        for (let c = 0; c < channels; c++) {
          const a = from.data[(top + left) * channels + c]
          const b = from.data[(top + right) * channels + c]
          const d = from.data[(bottom + left) * channels + c]
          const e = from.data[(bottom + right) * channels + c]
          to.data[(y * to.width + x) * channels + c] =
            colours && c < 3 ? colours.mean(a, b, d, e) : quarter(a + b + d + e)
        }
      }
    }
  }
}

/** Creates all levels that follow a given level, down to one texel, filled with 0. */
function smallerLevels(level: MipLevel): MipLevel[] {
  if (level.width === 1 && level.height === 1) return []
  const [width, height] = [Math.max(1, level.width >> 1), Math.max(1, level.height >> 1)]
  const smaller = { width, height, data: new Uint8Array(width * height * channelsOf(level)) }
  return [smaller, ...smallerLevels(smaller)]
}

/** Returns a quarter of an integer, rounded to the nearest integer, ties to even, as GPUs do. */
function quarter(sum: number): number {
  return (sum + 1 + ((sum >> 2) & 1)) >> 2
}

/** Number of steps of linear light in the lookup table. The sRGB bytes 0 and 1, whose linear values differ least, are five steps apart. */
const STEPS = 1 << 14

interface ColourTables {
  /** Returns the mean of four sRGB bytes, computed in linear light, as an sRGB byte. */
  mean(a: number, b: number, c: number, d: number): number
}

let tables: ColourTables | null = null

/** Returns lookup tables that convert between sRGB bytes and linear light. Cached, because computing them is slow. */
function colourTables(): ColourTables {
  if (tables) return tables
  const color = new Color()
  const light = Float32Array.from(
    { length: 256 },
    (_, byte) => color.setScalar(byte / 255).convertSRGBToLinear().r,
  )
  const bytes = Uint8Array.from({ length: STEPS + 1 }, (_, step) =>
    Math.round(255 * color.setScalar(step / STEPS).convertLinearToSRGB().r),
  )
  tables = {
    mean: (a, b, c, d) => bytes[Math.round(((light[a] + light[b] + light[c] + light[d]) * STEPS) / 4)],
  }
  return tables
}
