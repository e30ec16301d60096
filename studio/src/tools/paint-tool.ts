import type { GrayImage } from 'furrow'
import type { Ray } from 'three'
import type { Rectangle } from '../document/sculpted.ts'
import type { Brush, SculptBrush } from '../paint/brush.ts'
import { BrushStroke } from '../paint/brush-stroke.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import { around, type PaintedImage } from '../paint/painted.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { Sight } from '../paint/visible-places.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Image, brush and skin of a stroke. */
export interface PaintTarget<Image extends PaintedImage = GrayImage> {
  /** Name of the area or the layer that the image belongs to. */
  readonly name: string
  readonly image: Image
  readonly brush: Brush | SculptBrush
  readonly skin: PaintSkin
  /** Finds the skin under a pointer. */
  readonly picker: {
    pick(ray: Ray): SkinHit | undefined
    /**
     * Returns the texture coordinates under a ray. Only the texture view has this function, for strokes that are straight in UV space between
     * pointer events.
     */
    uvOf?(ray: Ray): [u: number, v: number]
  }
  /** Visibility test. Absent if hidden skin is painted too. */
  readonly sight?: Sight | undefined
}

export interface PaintToolParts<Target extends PaintTarget<PaintedImage>> {
  /**
   * Called at the start of a stroke and on hover. Returns the target, or null if there is nothing to paint.
   *
   * @param ray ray through the pointer.
   */
  target(ray: Ray): Target | null
  /** Returns a promise that settles when the target is ready, or null if there is nothing to wait for. */
  preparation(): Promise<unknown> | null
  /** Called when the stroke has changed the image. The receiver must call `showStroke` before it draws the next frame. */
  onPaint(): void
  /** Shows the stroke so far. @param changed changed texels since the last call. */
  show(target: Target, image: Target['image'], changed: Rectangle): void
  /** Stores the result of a stroke in the document. @param changed all changed texels. */
  keep(target: Target, image: Target['image'], changed: Rectangle): void
  /** Shows the image as it was before the stroke. */
  discard(target: Target): void
  /** Receives the skin under the pointer, or null. */
  onHit(hit: SkinHit | null): void
}

/** Pointer tool that changes an image with a brush. If the pointer is not on the face or Alt is pressed, the camera orbits instead. */
export class PaintTool<Target extends PaintTarget<PaintedImage> = PaintTarget> implements StageTool {
  readonly #parts: PaintToolParts<Target>
  #stroke: { target: Target; brush: BrushStroke<Target['image']> } | null = null
  /** Texels that the stroke has changed since the last call of `show`. */
  #changed: Rectangle | undefined

  constructor(parts: PaintToolParts<Target>) {
    this.#parts = parts
  }

  preparation(): Promise<unknown> | null {
    return this.#parts.preparation()
  }

  begin(pointer: StagePointer): boolean {
    const target = pointer.alt ? null : this.#parts.target(pointer.ray)
    if (!target?.picker.pick(pointer.ray)) return false
    const { image, brush, skin, sight } = target
    this.#stroke = { target, brush: new BrushStroke<Target['image']>(image, brush, skin, sight) }
    this.move([pointer])
    return true
  }

  move(pointers: readonly StagePointer[]): void {
    if (!this.#stroke) return
    const { target, brush } = this.#stroke
    let hit: SkinHit | undefined
    for (const { ray, pressure } of pointers) {
      hit = target.picker.pick(ray)
      const uv = target.picker.uvOf?.(ray)
      const changed = uv ? brush.moveInTexture(...uv, pressure) : brush.moveTo(hit, pressure)
      if (changed) this.#changed = this.#changed ? around(this.#changed, changed) : changed
    }
    this.#parts.onHit(hit ?? null)
    if (this.#changed) this.#parts.onPaint()
  }

  /** Shows the result of the current stroke so far, if it has changed since the last call. */
  showStroke(): void {
    const changed = this.#changed
    if (!this.#stroke || !changed) return
    this.#changed = undefined
    this.#parts.show(this.#stroke.target, this.#stroke.brush.image, changed)
  }

  end(): void {
    const stroke = this.#finish()
    if (!stroke) return
    const { image, dirty } = stroke.brush.end()
    if (dirty) this.#parts.keep(stroke.target, image, dirty)
  }

  cancel(): void {
    const stroke = this.#finish()
    if (stroke) this.#parts.discard(stroke.target)
  }

  hover(pointer: StagePointer | null): void {
    this.#parts.onHit((pointer && this.#parts.target(pointer.ray)?.picker.pick(pointer.ray)) ?? null)
  }

  #finish() {
    const stroke = this.#stroke
    this.#stroke = null
    this.#changed = undefined
    return stroke
  }
}
