import type { Bounds } from '../../core/bounds.ts'
import { FurrowError } from '../../core/error.ts'
import { resample } from '../../core/image.ts'
import { MAX_RELIEF } from '../../core/limits.ts'
import type { HeightMap } from './height.ts'

/** Maximum height above or below smooth skin to which sculpting moves skin, millimetres. */
export const MAX_SCULPTED = 1000 * MAX_RELIEF

/** Steps of 16-bit height images, and of sculpted heights, per millimetre. */
export const HEIGHT_STEPS_PER_MM = 1000

/**
 * Adds a sculpted height to the height of strokes, in millimetres. Sculpting moves skin at most `MAX_SCULPTED` up or down. Where strokes alone
 * exceed this, sculpting does not move skin farther from smooth skin.
 */
export function sculptedHeight(strokes: number, sculpted: number): number {
  const low = Math.min(strokes, -MAX_SCULPTED)
  const high = Math.max(strokes, MAX_SCULPTED)
  return Math.min(Math.max(strokes + sculpted, low), high)
}

/** Resamples heights like `resampleGray`. Returns `heights` if they have this size already. @internal */
export function resampleHeights(heights: HeightMap, width: number, height: number): HeightMap {
  if (heights.width === width && heights.height === height) return heights
  const { data, width: oldWidth, height: oldHeight } = heights
  return { width, height, data: Float32Array.from(resample(data, oldWidth, oldHeight, width, height)) }
}

/** Height map that is the sum of two others, see `sculptedHeight`. */
export class SculptedSum {
  readonly heights: HeightMap
  readonly sculpted: HeightMap
  readonly #strokes: HeightMap

  /**
   * Call `update` to compute the heights.
   *
   * @throws FurrowError if the maps differ in size.
   */
  constructor(strokes: HeightMap, sculpted: HeightMap) {
    const { width, height } = strokes
    if (sculpted.width !== width || sculpted.height !== height) {
      throw new FurrowError({
        who: 'StrokeLayer',
        problem: 'the sculpted heights differ from the canvas in size',
        value: `${sculpted.width} x ${sculpted.height}`,
        limit: `${width} x ${height}`,
        remedy: 'resample the heights',
      })
    }
    this.#strokes = strokes
    this.sculpted = sculpted
    this.heights = { width, height, data: new Float32Array(width * height) }
  }

  /** Computes the heights in rectangles again. */
  update(all: readonly Bounds[]): void {
    const { width, data } = this.heights
    for (const { x0, y0, x1, y1 } of all) {
      for (let y = y0; y < y1; y++) {
        for (let i = y * width + x0; i < y * width + x1; i++)
          data[i] = sculptedHeight(this.#strokes.data[i], this.sculpted.data[i])
      }
    }
  }
}
