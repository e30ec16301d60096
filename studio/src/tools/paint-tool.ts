import type { GrayImage } from 'furrow'
import type { Ray } from 'three'
import type { StudioArea } from '../document/document.ts'
import type { Brush } from '../paint/brush.ts'
import { BrushStroke } from '../paint/brush-stroke.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { Sight } from '../paint/seen-places.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** What a stroke paints. */
export interface PaintTarget {
  readonly area: StudioArea
  readonly brush: Brush
  readonly skin: PaintSkin
  /** Finds what is under a pointer. */
  readonly picker: {
    pick(ray: Ray): SkinHit | undefined
    /** Of a texture, on which strokes go straight: where a ray meets it. */
    uvOf?(ray: Ray): [u: number, v: number]
  }
  /** Absent where hidden skin is painted as well. */
  readonly sight?: Sight | undefined
}

export interface PaintToolParts {
  /** Called when a stroke begins and when the pointer hovers; null where there is nothing to paint. */
  target(): PaintTarget | null
  /** What makes the target; null once that is done. */
  waitsFor(): Promise<unknown> | null
  /** The painted weights have changed: `showStroke` is to be called before the next frame. */
  onPaint(): void
  /** Shows weights of an area that are not the document's, or are its own again. */
  show(area: string, weights: GrayImage): void
  /** A stroke has ended. */
  keep(area: string, weights: GrayImage): void
  /** Where the pointer is on the skin; null off it. */
  onHit(hit: SkinHit | null): void
}

/** Paints weights of an area with a brush. Beside the face and with Alt the camera orbits. */
export class PaintTool implements StageTool {
  readonly #parts: PaintToolParts
  #stroke: { target: PaintTarget; brush: BrushStroke } | null = null
  #isChanged = false

  constructor(parts: PaintToolParts) {
    this.#parts = parts
  }

  waitsFor(): Promise<unknown> | null {
    return this.#parts.waitsFor()
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

  /** Shows what the present stroke has painted since the last call. */
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
