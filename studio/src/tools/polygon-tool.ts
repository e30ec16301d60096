import type { SkinHit } from '../paint/picker.ts'
import type { Polygon } from './polygon.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Maximum distance from the first point for a click that closes the polygon, CSS pixels. */
const CLOSING = 12

export interface PolygonToolParts {
  polygon: Polygon
  /** Returns the skin under a pointer. */
  pick(pointer: StagePointer): SkinHit | undefined
  /** Returns the preparation of the skin, or null once it is ready. */
  preparation(): Promise<unknown> | null
  /** Projects a skin point to CSS pixels from the view's upper left corner. */
  project(hit: SkinHit): { x: number; y: number }
  /** Called when a click closes the polygon. */
  close(): void
}

/** Draws a polygon: a click adds a point, or closes the polygon at its first point. Off the skin, or with Alt, the camera moves. */
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

  /** Removes the point being placed. */
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
