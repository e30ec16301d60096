import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { splineOf } from './spline-of.ts'
import { knotsOf, type TracedStroke, traceStroke } from './traced-stroke.ts'

/** Line of a stroke (a wrinkle) on the skin, converted to a spline by `splineOf`. */
export interface StrokeLine extends TracedStroke {
  /** Index of the line's point at each point of the spline. */
  knots: readonly number[]
}

/** Traces the lines of strokes, and caches them by the identity of the stroke. */
export class StrokeLines {
  readonly skin: LocatedSkin
  readonly #lines = new WeakMap<Stroke, StrokeLine | null>()

  constructor(skin: LocatedSkin) {
    this.skin = skin
  }

  /** Returns null if the stroke is outside the skin. */
  lineOf(stroke: Stroke): StrokeLine | null {
    const known = this.#lines.get(stroke)
    if (known !== undefined) return known
    const spline = splineOf(stroke, this.skin)
    const traced = traceStroke(spline, this.skin)
    const line =
      traced.triangles.length === 0 ? null : { ...traced, knots: knotsOf(spline, traced, this.skin) }
    this.#lines.set(stroke, line)
    return line
  }
}
