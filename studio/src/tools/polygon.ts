import type { SkinHit } from '../paint/picker.ts'

const MIN_POINTS = 3

/** Points of an unfinished polygon on the skin. The views of the face and of its texture share them. */
export class Polygon {
  readonly #onChange: () => void
  #points: SkinHit[] = []
  #placed: SkinHit | null = null

  constructor(onChange: () => void) {
    this.#onChange = onChange
  }

  /** Points in the order of the clicks. The last one can be `placed`. */
  get points(): readonly SkinHit[] {
    return this.#placed ? [...this.#points, this.#placed] : this.#points
  }

  /** First point. A click on this point closes the polygon. Undefined while there are too few points. */
  get first(): SkinHit | undefined {
    return this.#points.length < MIN_POINTS ? undefined : this.#points[0]
  }

  /** Point under the pressed pointer, or null. Releasing the pointer adds it to the polygon. */
  get placed(): SkinHit | null {
    return this.#placed
  }

  set placed(placed: SkinHit | null) {
    this.#placed = placed
    this.#onChange()
  }

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
