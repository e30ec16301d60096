import type { GrayImage } from 'furrow'
import type { Rectangle } from '../document/sculpted.ts'
import type { Brush, SculptBrush } from './brush.ts'
import { Dabs } from './dabs.ts'
import type { PaintMap } from './paint-map.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import type { Painted, PaintedImage } from './painted.ts'
import { skinPath } from './skin-path.ts'
import { distanceBetween } from './vectors.ts'
import type { Sight } from './visible-places.ts'

/**
 * Distance between dabs (imprints of the brush) as a fraction of the radius. At this distance, the coverage of a stroke differs by at most 0.5%
 * from the coverage of a continuous brush.
 */
const SPACING = 0.08
/** Distance between dabs with a stamp: they lie side by side. */
const STAMP_SPACING = 2
/** Maximum step of a stroke that is drawn in the texture, texels. */
const TEXTURE_STEP = 0.5
/** A step in the texture crosses a UV seam if its length on the skin is more than this multiple of `TEXTURE_STEP`, converted to millimetres. */
const JUMP = 10

/** Brush stroke on an image: dabs at even distances on the skin, whatever the distances between pointer events. */
export class BrushStroke<Image extends PaintedImage = GrayImage> {
  readonly #isFill: boolean
  readonly #skin: PaintSkin
  readonly #map: PaintMap
  readonly #dabs: Dabs<Image>
  /** Distance between dabs as a fraction of the radius. */
  readonly #spacing: number
  #last: SkinPoint | undefined
  #lastPressure = 1
  #lastUv: readonly [u: number, v: number] | undefined
  /** Millimetres to the next dab. */
  #left = 0
  readonly #weights = new Float64Array(3)

  /**
   * @param image square image, not modified.
   * @param sight visibility test. Without it, hidden skin is painted too. Ignored in the mode `fill`.
   * @throws FurrowError if a brush setting is out of range, or the image cannot be painted.
   */
  constructor(image: Image, brush: Brush | SculptBrush, skin: PaintSkin, sight?: Sight) {
    this.#dabs = new Dabs(image, brush, skin, sight)
    this.#map = skin.mapOf(image.width)
    this.#isFill = brush.mode === 'fill'
    this.#spacing = brush.stamp ? STAMP_SPACING : SPACING
    this.#skin = skin
  }

  /** Painted image. Its data changes with each dab. */
  get image(): Image {
    return this.#dabs.image
  }

  /**
   * Continues the stroke to a point on the skin.
   *
   * @param point point on the skin, or undefined if the pointer is not on the face. Undefined interrupts the stroke.
   * @param pressure pen pressure, 0..1. Default 1.
   * @returns rectangle of the texels that this call changed, or undefined if there are none.
   */
  moveTo(point: SkinPoint | undefined, pressure = 1): Rectangle | undefined {
    this.#lastUv = undefined
    this.#advance(point, pressure)
    return this.#dabs.takeChanged()
  }

  /** Continues the stroke along a straight line in the texture. The stroke is interrupted where the line leaves a UV island. */
  moveInTexture(u: number, v: number, pressure = 1): Rectangle | undefined {
    const [fromU, fromV] = this.#lastUv ?? [u, v]
    const first = this.#lastPressure
    const steps = Math.ceil((Math.hypot(u - fromU, v - fromV) * this.#map.size) / TEXTURE_STEP) || 1
    for (let i = 1; i <= steps; i++) {
      const t = i / steps
      const point = this.#pointAt(fromU + t * (u - fromU), fromV + t * (v - fromV))
      if (point && this.#isJump(point)) this.#last = undefined
      this.#advance(point, this.#lastUv ? first + t * (pressure - first) : pressure)
    }
    this.#lastUv = [u, v]
    return this.#dabs.takeChanged()
  }

  end(): Painted<Image> {
    return { image: this.image, dirty: this.#dabs.changed }
  }

  #pointAt(u: number, v: number): SkinPoint | undefined {
    const triangle = this.#map.locator.find(u, v, this.#weights)
    if (triangle < 0) return undefined
    const { points, corners } = this.#skin.surface
    const position = [0, 1, 2].map((k) =>
      this.#weights.reduce((sum, weight, i) => sum + weight * points[3 * corners[3 * triangle + i] + k], 0),
    )
    return { triangle, position: position as [number, number, number] }
  }

  #isJump({ triangle, position }: SkinPoint): boolean {
    if (!this.#last) return false
    const usual =
      TEXTURE_STEP * Math.max(...[triangle, this.#last.triangle].map((t) => this.#map.texelSizes[t]))
    return distanceBetween(position, this.#last.position) > JUMP * usual
  }

  #advance(point: SkinPoint | undefined, pressure: number): void {
    const [from, fromPressure] = [this.#last, this.#lastPressure]
    this.#last = point
    this.#lastPressure = pressure
    if (!point) return
    if (this.#isFill) {
      if (!from && !this.#dabs.changed) this.#dabs.fill(point)
      return
    }
    const path = from && skinPath(this.#skin.surface, from, point)
    if (path) this.#dabAlong(path, fromPressure, pressure)
    else {
      this.#dabs.add(point, pressure)
      this.#left = this.#spacingAt(point)
    }
  }

  #dabAlong(path: readonly SkinPoint[], startPressure: number, endPressure: number): void {
    let total = 0
    for (let i = 1; i < path.length; i++) total += distanceBetween(path[i - 1].position, path[i].position)
    let done = 0
    for (let i = 1; i < path.length; i++) {
      const [from, to] = [path[i - 1], path[i]]
      const length = distanceBetween(from.position, to.position)
      let along = 0
      while (length - along >= this.#left) {
        along += this.#left
        const t = length > 0 ? along / length : 1
        const [[x, y, z], [toX, toY, toZ]] = [from.position, to.position]
        const position = [x + t * (toX - x), y + t * (toY - y), z + t * (toZ - z)] as const
        const dab = { triangle: from.triangle, position }
        this.#dabs.add(dab, startPressure + ((done + along) / total) * (endPressure - startPressure))
        this.#left = this.#spacingAt(dab)
      }
      this.#left -= length - along
      done += length
    }
  }

  #spacingAt(point: SkinPoint): number {
    return this.#spacing * this.#dabs.radiusAt(point)
  }
}
