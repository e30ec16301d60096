import type { SkinHit } from '../paint/picker.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** CSS pixels from the first point within which a click closes the polygon. */
const CLOSING = 12
/** Fewest points of a polygon. */
const LEAST_POINTS = 3

export interface PolygonToolParts {
  /** The skin under a pointer. */
  pick(pointer: StagePointer): SkinHit | undefined
  /** Where a point of the skin is now, in CSS pixels from the stage's upper left corner. */
  project(hit: SkinHit): { x: number; y: number }
  /** The polygon is closed. */
  close(points: readonly SkinHit[]): void
  /** The points are others. */
  changed(): void
}

/** Draws a polygon on the face: a click adds a point, one on the first point closes it. Beside the face and with Alt the camera orbits. */
export class PolygonTool implements StageTool {
  readonly #parts: PolygonToolParts
  #points: SkinHit[] = []
  /** The point that is being placed; null while a click closes the polygon. */
  #placed: SkinHit | null = null

  constructor(parts: PolygonToolParts) {
    this.#parts = parts
  }

  /** In the order of the clicks, with the one that is being placed. */
  get points(): readonly SkinHit[] {
    return this.#placed ? [...this.#points, this.#placed] : this.#points
  }

  begin(pointer: StagePointer): boolean {
    if (pointer.alt) return false
    const isClosing = this.#isOnFirst(pointer)
    const hit = this.#parts.pick(pointer)
    if (!isClosing && !hit) return false
    this.#place(isClosing ? null : hit!)
    return true
  }

  move(pointers: readonly StagePointer[]): void {
    const hit = this.#placed && pointers.length > 0 && this.#parts.pick(pointers.at(-1)!)
    if (hit) this.#place(hit)
  }

  end(): void {
    const placed = this.#placed
    if (placed) {
      this.#points.push(placed)
      this.#place(null)
    } else this.close()
  }

  /** Takes back the point that is being placed. */
  cancel(): void {
    this.#place(null)
  }

  /** Paints what is enclosed, where there are enough points, and begins anew. */
  close(): void {
    if (this.#points.length < LEAST_POINTS) return
    const points = this.#points
    this.clear()
    this.#parts.close(points)
  }

  removeLast(): void {
    this.#points.pop()
    this.#parts.changed()
  }

  clear(): void {
    this.#points = []
    this.#place(null)
  }

  #place(hit: SkinHit | null): void {
    this.#placed = hit
    this.#parts.changed()
  }

  #isOnFirst({ x, y }: StagePointer): boolean {
    if (this.#points.length < LEAST_POINTS) return false
    const first = this.#parts.project(this.#points[0])
    return Math.hypot(first.x - x, first.y - y) <= CLOSING
  }
}
