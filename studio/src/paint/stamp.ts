import type { GrayImage } from 'furrow'
import { crossOf, interpolateTexels, type SkinSurface } from 'furrow/internal'
import type { SkinPoint } from './paint-skin.ts'
import { cross } from './vectors.ts'

/** Gray image that shapes a dab. White has the full effect, black none. The dab's circle touches the sides of the image. */
export type Stamp = GrayImage

/** Stamp on the skin. Its plane touches the skin at the centre of a dab. Up in the image is up on the face. */
export class PlacedStamp {
  readonly #stamp: Stamp
  readonly #right: ArrayLike<number>
  readonly #up: ArrayLike<number>

  constructor(stamp: Stamp, surface: SkinSurface, { triangle }: SkinPoint) {
    this.#stamp = stamp
    const normal = new Float64Array(3)
    const [a, b, c] = surface.corners.subarray(3 * triangle, 3 * triangle + 3)
    crossOf(surface.points, a, b, c, normal)
    const above = Math.abs(normal[1]) > 0.99 * Math.hypot(...normal) ? [0, 0, -1] : [0, 1, 0]
    this.#right = unit(cross(above, normal))
    this.#up = unit(cross(normal, this.#right))
  }

  /**
   * Returns the effect of the stamp, 0..1.
   *
   * @param x distance from the centre of the dab as a fraction of the radius, like `y` and `z`.
   */
  at(x: number, y: number, z: number): number {
    const { width, height, data } = this.#stamp
    const along = (axis: ArrayLike<number>) => x * axis[0] + y * axis[1] + z * axis[2]
    const [u, v] = [(1 + along(this.#right)) / 2, (1 - along(this.#up)) / 2]
    if (!(u >= 0 && v >= 0 && u <= 1 && v <= 1)) return 0
    const texel = (i: number, j: number) => data[j * width + i]
    return interpolateTexels(this.#stamp, u * width - 0.5, v * height - 0.5, texel) / 255
  }
}

function unit(vector: Float64Array): Float64Array {
  const length = Math.hypot(...vector)
  return vector.map((value) => value / length)
}
