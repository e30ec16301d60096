import type { SkinHit } from '../paint/picker.ts'

/** Minimum number of points. */
const MIN_POINTS = 3

/** Points of an unfinished polygon on the skin, shared by all views. */
export class Polygon {
  readonly #onChange: () => void
  #points: SkinHit[] = []
  #placed: SkinHit | null = null

  /** @param onChange called when the points change. */
  constructor(onChange: () => void) {
    this.#onChange = onChange
  }

  /** Points in click order, including the one being placed. */
  get points(): readonly SkinHit[] {
    return this.#placed ? [...this.#points, this.#placed] : this.#points
  }

  /** First point, where a click closes the polygon. Undefined while there are too few points. */
  get first(): SkinHit | undefined {
    return this.#points.length < MIN_POINTS ? undefined : this.#points[0]
  }

  /** Point being placed, or null. */
  get placed(): SkinHit | null {
    return this.#placed
  }

  set placed(placed: SkinHit | null) {
    this.#placed = placed
    this.#onChange()
  }

  /** Adds the point being placed. */
  add(): void {
    if (this.#placed) this.#points.push(this.#placed)
    this.placed = null
  }

  removeLast(): void {
    this.#points.pop()
    this.#onChange()
  }

  clear(): void {
    this.#points = []
    this.placed = null
  }

  /** Returns and removes all points, or returns null if there are too few. */
  take(): readonly SkinHit[] | null {
    if (!this.first) return null
    const points = this.#points
    this.clear()
    return points
  }
}
