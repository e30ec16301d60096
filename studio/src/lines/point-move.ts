import type { Uv } from 'furrow/author'
import {
  type ChangedStrokes,
  type Fork,
  type ForkedStrokes,
  findForks,
  moveFork,
  pullBranches,
  type StrokeLines,
  withForkPoints,
  withPoint,
} from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import type { Handle } from './handles.ts'

/**
 * Gesture that moves a handle of a line. Forks are those at its start, so that lines do not join while one of them is moved across another.
 */
export class PointMove {
  /** Whether the gesture moves a fork. */
  readonly isFork: boolean
  /** Strokes of the document after the last move. */
  last: readonly LayerStroke[]
  readonly #index: number
  readonly #knot: number
  readonly #fork: Fork | null
  readonly #before: ForkedStrokes<LayerStroke>
  #changed: ChangedStrokes<LayerStroke> = new Map()
  #uv: Uv = [0, 0]

  /** @param index index of the line's stroke. */
  constructor(strokes: readonly LayerStroke[], index: number, { knot, fork }: Handle, lines: StrokeLines) {
    const own = fork ? withForkPoints(strokes, fork, lines) : strokes
    const forks = findForks(own, lines)
    this.last = strokes
    this.isFork = fork !== null
    this.#index = index
    this.#knot = knot
    this.#fork = fork && forks.find((each) => isSame(each, fork))!
    this.#before = { strokes: own, forks, lines }
  }

  /** Indices of the strokes that have a point at the handle. */
  get indices(): readonly number[] {
    return this.#fork ? [...this.#fork.ends, ...this.#fork.trunks].map(({ stroke }) => stroke) : [this.#index]
  }

  /** Last position of the handle. */
  get uv(): Uv {
    return this.#uv
  }

  /** Indices of all strokes that the gesture has changed. */
  get changed(): ReadonlySet<number> {
    return new Set(this.#changed.keys())
  }

  /** Returns the strokes that change when the handle moves to a position. */
  to(uv: Uv): ReadonlyMap<number, LayerStroke> {
    const { strokes, lines } = this.#before
    this.#uv = uv
    this.#changed = this.#fork
      ? moveFork(this.#before, this.#fork, uv)
      : pullBranches(
          this.#before,
          new Map([[this.#index, withPoint(strokes[this.#index], this.#knot, uv, lines)]]),
        )
    return this.#changed
  }
}

function isSame(a: Fork, b: Fork): boolean {
  return a.ends.some(({ stroke, end }) =>
    b.ends.some((other) => other.stroke === stroke && other.end === end),
  )
}
