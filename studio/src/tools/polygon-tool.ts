import type { SkinHit } from '../paint/picker.ts'
import type { Polygon } from './polygon.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Maximum distance from the first point at which a click closes the polygon, CSS pixels. */
const CLOSING = 12

export interface PolygonToolParts {
  polygon: Polygon
  /** Returns the skin under a pointer. */
  pick(pointer: StagePointer): SkinHit | undefined
  /** Returns a promise that settles when the skin is ready, or null if there is nothing to wait for. */
  preparation(): Promise<unknown> | null
  /** Projects a skin point to CSS pixels from the view's upper left corner. */
  project(hit: SkinHit): { x: number; y: number }
  /** Called when a click closes the polygon. */
  close(): void
}

/**
 * Pointer tool that draws a polygon. A click adds a point. A click on the first point closes the polygon. If the pointer is not on the skin or
 * Alt is pressed, the camera moves instead.
 */
export class PolygonTool implements StageTool {
  readonly #parts: PolygonToolParts

  constructor(parts: PolygonToolParts) {
    this.#parts = parts
  }

  preparation(): Promise<unknown> | null {
    return this.#parts.preparation()
  }

  begin(pointer: StagePointer): boolean {
    if (pointer.alt) return false
    const isClosing = this.#isOnFirst(pointer)
    const hit = this.#parts.pick(pointer)
    if (!isClosing && !hit) return false
    this.#parts.polygon.placed = isClosing ? null : hit!
    return true
  }

  move(pointers: readonly StagePointer[]): void {
    const { polygon, pick } = this.#parts
    const hit = polygon.placed && pointers.length > 0 && pick(pointers.at(-1)!)
    if (hit) polygon.placed = hit
  }

  end(): void {
    const { polygon, close } = this.#parts
    if (polygon.placed) polygon.add()
    else close()
  }

  /** Removes the point that the user is placing. */
  cancel(): void {
    this.#parts.polygon.placed = null
  }

  #isOnFirst({ x, y }: StagePointer): boolean {
    const { polygon, project } = this.#parts
    if (!polygon.first) return false
    const first = project(polygon.first)
    return Math.hypot(first.x - x, first.y - y) <= CLOSING
  }
}
