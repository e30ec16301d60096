import { clamp, smoothstep } from '../../math/scalar.ts'
import { positionAt } from '../skin/walk.ts'
import type { LocatedSkin } from '../strokes/curve.ts'
import type { Furrows } from './read-furrows.ts'

/** Count of numbers per region: centre, squared radius, size and depth. */
const REGION = 6
/** Minimum sum of the regions' weights at which furrows have their full depth. */
const FULL = 0.6

/** Computes the cell size and the furrow depth of a pattern of fine furrows at a position. Both can differ between regions of the skin. */
export class LocalCells {
  /** Smallest cell size of any region, in millimetres. */
  readonly smallest: number
  /** Largest cell size of any region, in millimetres. */
  readonly largest: number
  /** Cell size at the last position passed to `find`, in millimetres. */
  size: number
  /** Depth of furrows at the last position passed to `find`, in millimetres; 0 outside all regions. */
  depth: number
  /** `REGION` numbers per region. Undefined if size and depth are the same everywhere. */
  readonly #regions: Float64Array | undefined

  constructor({ size, depth, regions }: Furrows, { surface, locator }: LocatedSkin) {
    this.size = size
    this.depth = depth
    const weights = new Float64Array(3)
    const position = new Float64Array(3)
    const placed = regions?.flatMap(({ at, radius, ...cells }) => {
      const triangle = locator.find(at[0], at[1], weights)
      if (triangle < 0) return []
      positionAt(position, surface, triangle, weights)
      return [...position, radius ** 2, cells.size, cells.depth]
    })
    this.#regions = placed && Float64Array.from(placed)
    const sizes = regions?.map((region) => region.size) ?? [size]
    this.smallest = Math.min(...sizes)
    this.largest = Math.max(...sizes)
  }

  /**
   * Sets `size` and `depth` to weighted means over the regions that contain a position. A region's weight falls to 0 at its radius. Where the
   * sum of weights is below `FULL`, the depth is reduced. Outside all regions, `size` is the largest size and `depth` is 0.
   */
  find(x: number, y: number, z: number): void {
    const regions = this.#regions
    if (!regions) return
    let [total, size, depth] = [0, 0, 0]
    for (let i = 0; i < regions.length; i += REGION) {
      const square = (x - regions[i]) ** 2 + (y - regions[i + 1]) ** 2 + (z - regions[i + 2]) ** 2
      if (square >= regions[i + 3]) continue
      const weight = (1 - square / regions[i + 3]) ** 2
      total += weight
      size += weight * regions[i + 4]
      depth += weight * regions[i + 5]
    }
    this.size = total > 0 ? size / total : this.largest
    this.depth = total > 0 ? (depth / total) * smoothstep(total / FULL) : 0
  }

  /** Returns whether a box may contain furrows. */
  isIn(low: Float64Array, high: Float64Array): boolean {
    const regions = this.#regions
    if (!regions) return true
    for (let i = 0; i < regions.length; i += REGION) {
      let square = 0
      for (let k = 0; k < 3; k++) square += (clamp(regions[i + k], low[k], high[k]) - regions[i + k]) ** 2
      if (square < regions[i + 3]) return true
    }
    return false
  }
}
