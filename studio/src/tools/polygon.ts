import type { SkinHit } from '../paint/picker.ts'

/** Fewest points of a polygon. */
const LEAST_POINTS = 3

/** The points of a polygon on the skin while it is drawn, whichever view they are clicked in. */
export class Polygon {
  readonly #onChange: () => void
  #points: SkinHit[] = []
  #placed: SkinHit | null = null

  /** @param onChange the points are others. */
  constructor(onChange: () => void) {
    this.#onChange = onChange
  }

  /** In the order of the clicks, with the one that is being placed. */
  get points(): readonly SkinHit[] {
    return this.#placed ? [...this.#points, this.#placed] : this.#points
  }

  /** The first point, where a click on it closes the polygon; undefined while there are too few. */
  get first(): SkinHit | undefined {
    return this.#points.length < LEAST_POINTS ? undefined : this.#points[0]
  }

  /** The point that is being placed; null for none. */
  get placed(): SkinHit | null {
    return this.#placed
  }

  set placed(placed: SkinHit | null) {
    this.#placed = placed
    this.#onChange()
  }

  /** Keeps the point that is being placed. */
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

  /** All points, of which none is left; null where they are too few. */
  take(): readonly SkinHit[] | null {
    if (!this.first) return null
    const points = this.#points
    this.clear()
    return points
  }
}
