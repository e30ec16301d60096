import { positionAt } from 'furrow/internal'
import { type Ray, Vector3 } from 'three'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinHit, SkinPicker } from '../paint/picker.ts'

const CORNERS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const

/** Finds the point of a skin under the pointer in the view of its texture. */
export class TexturePicker {
  readonly #skin: PaintSkin
  readonly #posed: Pick<SkinPicker, 'positionOf'>
  readonly #size: number

  /**
   * @param posed skin in its current pose.
   * @param size width and height of the areas, texels.
   */
  constructor(skin: PaintSkin, posed: Pick<SkinPicker, 'positionOf'>, size: number) {
    this.#skin = skin
    this.#posed = posed
    this.#size = size
  }

  /** Returns the texture coordinates that a ray of the `TextureCamera` hits, also outside the skin. */
  uvOf({ origin: { x, y } }: Ray): [u: number, v: number] {
    return [x, -y]
  }

  /** Returns the point of the skin that a ray hits, or undefined outside the skin. If several parts of the skin overlap, the first one counts. */
  pick(ray: Ray): SkinHit | undefined {
    const own = new Float64Array(3)
    const uv = this.uvOf(ray)
    const triangle = this.#skin.mapOf(this.#size).locator.find(...uv, own)
    if (triangle < 0) return undefined
    const position = new Float64Array(3)
    positionAt(position, this.#skin.surface, triangle, own)
    const [a, b, c] = CORNERS.map((corner) => this.#posed.positionOf(triangle, corner, new Vector3()))
    return {
      triangle,
      weights: [own[0], own[1], own[2]],
      position: [position[0], position[1], position[2]],
      uv,
      point: this.#posed.positionOf(triangle, [...own], new Vector3()),
      normal: b.sub(a).cross(c.sub(a)).normalize(),
    }
  }
}
