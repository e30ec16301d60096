import type { HeightMap } from 'furrow/author'
import { type Bounds, HEIGHT_STEPS_PER_MM, interpolateTexels, mergeBounds } from 'furrow/internal'
import { type SculptedTile, TILE, tileRectangle } from '../document/sculpted.ts'
import type { SculptedChanges } from './changes.ts'

/** Sculpted heights of a layer in millimetres, at the size of its maps. */
export class SculptedSheet {
  /** `update` changes this map in place. */
  readonly heights: HeightMap
  /** Heights at their own size, in steps of `HEIGHT_STEPS_PER_MM`. */
  #own: { size: number; data: Int16Array } = { size: 0, data: new Int16Array() }

  /** @param size width and height of the layer's maps, texels. */
  constructor(size: number) {
    this.heights = { width: size, height: size, data: new Float32Array(size * size) }
  }

  /** Applies changes. Returns the changed rectangles of `heights`. */
  update({ size, tiles }: SculptedChanges): Bounds[] {
    const isResized = size !== this.#own.size && this.#own.size > 0
    if (size !== this.#own.size) this.#own = { size, data: new Int16Array(size * size) }
    const changed = Array.from(tiles, ([index, tile]) => this.#write(index, tile))
    const whole = { x0: 0, y0: 0, x1: this.heights.width, y1: this.heights.height }
    const all = mergeBounds(isResized ? [whole] : changed)
    for (const bounds of all) this.#draw(bounds)
    return all
  }

  /** Writes a tile, and returns the texels of `heights` that depend on it. */
  #write(index: number, tile: SculptedTile | undefined): Bounds {
    const { size, data } = this.#own
    const { x, y, width, height } = tileRectangle(index, size)
    for (let row = 0; row < height; row++) {
      const start = (y + row) * size + x
      if (tile) data.set(tile.subarray(row * TILE, row * TILE + width), start)
      else data.fill(0, start, start + width)
    }
    const side = this.heights.width
    if (side === size) return { x0: x, y0: y, x1: x + width, y1: y + height }
    const scale = side / size
    const [first, last] = [
      (at: number) => Math.floor((at - 1) * scale),
      (at: number) => Math.ceil((at + 1) * scale),
    ]
    return {
      x0: Math.max(first(x), 0),
      y0: Math.max(first(y), 0),
      x1: Math.min(last(x + width), side),
      y1: Math.min(last(y + height), side),
    }
  }

  #draw({ x0, y0, x1, y1 }: Bounds): void {
    const { width, data } = this.heights
    const { size, data: own } = this.#own
    const isSame = width === size
    for (let y = y0; y < y1; y++) {
      for (let x = x0; x < x1; x++) {
        const steps = isSame ? own[y * size + x] : this.#sample((x + 0.5) / width, (y + 0.5) / width)
        data[y * width + x] = steps / HEIGHT_STEPS_PER_MM
      }
    }
  }

  /** Interpolates the heights bilinearly. */
  #sample(u: number, v: number): number {
    const { size, data } = this.#own
    const texel = (i: number, j: number) => data[j * size + i]
    return interpolateTexels({ width: size, height: size }, u * size - 0.5, v * size - 0.5, texel)
  }
}
