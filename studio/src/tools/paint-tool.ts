import type { GrayImage } from 'furrow'
import type { Ray } from 'three'
import type { StudioArea } from '../document/document.ts'
import type { Brush } from '../paint/brush.ts'
import { BrushStroke } from '../paint/brush-stroke.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { Sight } from '../paint/visible-places.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Area, brush and skin of a stroke. */
export interface PaintTarget {
  readonly area: StudioArea
  readonly brush: Brush
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

export interface PaintToolParts {
  /** Called at the start of a stroke and on hover. Returns the target, or null if there is nothing to paint. */
  target(): PaintTarget | null
  /** Returns a promise that settles when the target is ready, or null if there is nothing to wait for. */
  preparation(): Promise<unknown> | null
  /** Called when the stroke has changed weights. The receiver must call `showStroke` before it draws the next frame. */
  onPaint(): void
  /** Shows weights of an area on the face without changing the document. */
  show(area: string, weights: GrayImage): void
  /** Stores the result of a stroke in the document. */
  keep(area: string, weights: GrayImage): void
  /** Receives the skin under the pointer, or null. */
  onHit(hit: SkinHit | null): void
}

/** Pointer tool that paints an area with a brush. If the pointer is not on the face or Alt is pressed, the camera orbits instead. */
export class PaintTool implements StageTool {
  readonly #parts: PaintToolParts
  #stroke: { target: PaintTarget; brush: BrushStroke } | null = null
  #isChanged = false

  constructor(parts: PaintToolParts) {
    this.#parts = parts
  }

  preparation(): Promise<unknown> | null {
    return this.#parts.preparation()
  }

  begin(pointer: StagePointer): boolean {
    const target = pointer.alt ? null : this.#parts.target()
    if (!target?.picker.pick(pointer.ray)) return false
    const { area, brush, skin, sight } = target
    this.#stroke = { target, brush: new BrushStroke(area.weights, brush, skin, sight) }
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
      if (uv ? brush.moveInTexture(...uv, pressure) : brush.moveTo(hit, pressure)) this.#isChanged = true
    }
    this.#parts.onHit(hit ?? null)
    if (this.#isChanged) this.#parts.onPaint()
  }

  /** Shows the result of the current stroke so far, if it has changed since the last call. */
  showStroke(): void {
    if (!this.#stroke || !this.#isChanged) return
    this.#isChanged = false
    this.#parts.show(this.#stroke.target.area.name, this.#stroke.brush.image)
  }

  end(): void {
    const stroke = this.#finish()
    if (!stroke) return
    const { image, dirty } = stroke.brush.end()
    if (dirty) this.#parts.keep(stroke.target.area.name, image)
  }

  cancel(): void {
    const stroke = this.#finish()
    if (!stroke) return
    const { name, weights } = stroke.target.area
    this.#parts.show(name, weights)
    this.#parts.onPaint()
  }

  hover(pointer: StagePointer | null): void {
    this.#parts.onHit((pointer && this.#parts.target()?.picker.pick(pointer.ray)) ?? null)
  }

  #finish() {
    const stroke = this.#stroke
    this.#stroke = null
    this.#isChanged = false
    return stroke
  }
}
