import { type Bounds, grown, widen } from '../../core/bounds.ts'

/** The map is divided into squares of this width and height in texels. One rectangle of changed texels is collected per square. */
const SIDE = 16
/** Two rectangles are merged if their bounding box has at most this many texels more than both together. */
const SLACK = 4096

/** Collects the changed texels of a map, and returns rectangles that contain them. */
export class ChangedTexels {
  readonly #width: number
  readonly #height: number
  /** Bounds of the changed texels in each square, by square index. */
  readonly #squares = new Map<number, Bounds>()

  constructor(width: number, height: number) {
    this.#width = width
    this.#height = height
  }

  add(texel: number): void {
    const [x, y] = [texel % this.#width, Math.floor(texel / this.#width)]
    const square = Math.floor(y / SIDE) * Math.ceil(this.#width / SIDE) + Math.floor(x / SIDE)
    const own = { x0: x, y0: y, x1: x + 1, y1: y + 1 }
    const bounds = this.#squares.get(square)
    if (bounds) widen(bounds, own)
    else this.#squares.set(square, own)
  }

  /** Returns rectangles that contain the changed texels. Each rectangle is grown by `margin` texels and clipped to the map. */
  around(margin: number): Bounds[] {
    const whole = { x0: 0, y0: 0, x1: this.#width, y1: this.#height }
    return Array.from(this.#squares.values(), (bounds) => grown(bounds, margin, whole))
  }
}

/** Merges rectangles that are close to each other (see `SLACK`). */
export function mergeBounds(all: readonly Bounds[]): Bounds[] {
  let merged: Bounds[] = []
  for (const bounds of all) {
    const union = { ...bounds }
    for (;;) {
      const other = merged.find((each) => isWorthMerging(union, each))
      if (!other) break
      widen(union, other)
      merged = merged.filter((each) => each !== other)
    }
    merged.push(union)
  }
  return merged
}

function isWorthMerging(a: Bounds, b: Bounds): boolean {
  const both = { ...a }
  widen(both, b)
  return areaOf(both) <= areaOf(a) + areaOf(b) + SLACK
}

function areaOf({ x0, y0, x1, y1 }: Bounds): number {
  return (x1 - x0) * (y1 - y0)
}
