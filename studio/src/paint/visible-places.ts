import type { PaintMap } from './paint-map.ts'
import { clampedBarycentrics, type PaintSkin } from './paint-skin.ts'

/**
 * Visibility test for a point of the skin.
 *
 * @param weights barycentric coordinates in the triangle.
 */
export type Sight = (triangle: number, weights: Float64Array) => boolean

const VISIBLE = 1
const HIDDEN = 2

/** Tests and caches the visibility of places. In the code, a place is a pair of a texel and a triangle that contains it; see `PaintMapArrays`. */
export class VisiblePlaces {
  readonly #skin: PaintSkin
  readonly #map: PaintMap
  readonly #sight: Sight
  readonly #isMirrored: boolean
  /** `VISIBLE`, `HIDDEN`, or 0 if unknown. */
  readonly #known: Uint8Array
  readonly #weights = new Float64Array(3)

  /** @param isMirrored whether to test the mirror image of each place instead. */
  constructor(skin: PaintSkin, map: PaintMap, sight: Sight, isMirrored: boolean) {
    this.#skin = skin
    this.#map = map
    this.#sight = sight
    this.#isMirrored = isMirrored
    this.#known = new Uint8Array(map.texels.length)
  }

  has(place: number, triangle: number): boolean {
    if (this.#known[place] === 0) this.#known[place] = this.#test(place, triangle) ? VISIBLE : HIDDEN
    return this.#known[place] === VISIBLE
  }

  #test(place: number, triangle: number): boolean {
    const { positions } = this.#map
    const position = [positions[3 * place], positions[3 * place + 1], positions[3 * place + 2]] as const
    const point = this.#isMirrored ? this.#skin.mirrored(position) : { triangle, position }
    clampedBarycentrics(this.#skin.surface, point.triangle, point.position, this.#weights)
    return this.#sight(point.triangle, this.#weights)
  }
}
