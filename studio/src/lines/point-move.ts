import type { Uv } from 'furrow/author'
import {
  type ChangedStrokes,
  type Fork,
  type ForkedStrokes,
  findForks,
  grabPoint,
  grabStroke,
  grabWeights,
  heldEnds,
  moveFork,
  moveOver,
  placeAt,
  pointAt,
  pullBranches,
  type StrokeLines,
  stepTo,
  withForkPoints,
} from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import { STEP } from '../labels/steps.ts'
import type { Handle } from './handles.ts'

/**
 * Gesture that moves a handle of a line, and the points near it. Forks are those at its start, so that lines do not join while one of them is
 * moved across another.
 */
export class PointMove {
  /** Label of the undo step. */
  readonly label: string
  /** Strokes of the document before the gesture. */
  readonly first: readonly LayerStroke[]
  /** Strokes of the document after the last move. */
  last: readonly LayerStroke[]
  readonly #index: number
  readonly #others: readonly number[]
  readonly #knot: number
  readonly #fork: Fork | null
  /** Position of the handle before the gesture, millimetres, and its triangle of the skin. */
  readonly #from: Float64Array
  readonly #triangle: number
  readonly #before: ForkedStrokes<LayerStroke>
  #uv: Uv = [0, 0]

  /** @param indices indices of the strokes to move. The handle belongs to the first one. */
  constructor(
    strokes: readonly LayerStroke[],
    [index, ...others]: readonly number[],
    { place, knot, fork }: Handle,
    lines: StrokeLines,
  ) {
    const own = fork ? withForkPoints(strokes, fork, lines) : strokes
    const forks = findForks(own, lines)
    this.first = strokes
    this.last = strokes
    this.label = fork ? STEP.moveFork : STEP.movePoint
    this.#index = index
    this.#others = others
    this.#knot = knot
    this.#fork = fork && forks.find((each) => isSame(each, fork))!
    const line = lines.lineOf(strokes[index])!
    this.#from = pointAt(line, place).slice()
    this.#triangle = line.triangles[place]
    this.#before = { strokes: own, forks, lines }
  }

  /** Whether a stroke has a point at the handle. */
  hasHandle(index: number): boolean {
    const members = this.#fork ? [...this.#fork.ends, ...this.#fork.trunks] : [{ stroke: this.#index }]
    return members.some(({ stroke }) => stroke === index)
  }

  /** Returns the position of the handle after the motion of the pointer from one place to another. Returns null if one is outside the skin. */
  follow(from: Uv, to: Uv): Uv | null {
    const { lines } = this.#before
    const start = placeAt(from, lines.skin)
    const step = start && stepTo(start.position, to, lines)
    return step && moveOver({ triangle: this.#triangle, position: this.#from }, step, lines.skin)
  }

  /** Last position of the handle. */
  get uv(): Uv {
    return this.#uv
  }

  /**
   * Returns the strokes that change when the handle moves to a position.
   *
   * @param radius arc length up to which neighbouring points move too, millimetres.
   */
  to(uv: Uv, radius: number): ReadonlyMap<number, LayerStroke> {
    this.#uv = uv
    const changed: ChangedStrokes<LayerStroke> = this.#fork
      ? moveFork(this.#before, this.#fork, uv, radius)
      : new Map([[this.#index, grabPoint(this.#before, this.#index, this.#knot, { uv, radius })]])
    const step = this.#others.length > 0 ? stepTo(this.#from, uv, this.#before.lines) : null
    for (const index of this.#others)
      if (step && !changed.has(index)) changed.set(index, this.#moveOther(index, step, radius))
    return pullBranches(this.#before, changed)
  }

  /** Moves another chosen stroke like the first one, around its point that is nearest to the handle. Its ends in forks stay. */
  #moveOther(index: number, step: Float64Array, radius: number): LayerStroke {
    const { strokes, forks, lines } = this.#before
    const line = lines.lineOf(strokes[index])
    if (!line) return strokes[index]
    const held = heldEnds(forks, index)
    const isHeld = (knot: number) =>
      (knot === 0 && held.includes(0)) || (knot === line.knots.length - 1 && held.includes(1))
    let [nearest, least] = [-1, Number.POSITIVE_INFINITY]
    for (const [knot, place] of line.knots.entries()) {
      const distance = Math.hypot(...pointAt(line, place).map((value, k) => value - this.#from[k]))
      if (isHeld(knot) || distance >= least) continue
      nearest = knot
      least = distance
    }
    if (nearest < 0) return strokes[index]
    return grabStroke(strokes[index], step, grabWeights(line, nearest, radius, held), lines)
  }
}

function isSame(a: Fork, b: Fork): boolean {
  return a.ends.some(({ stroke, end }) =>
    b.ends.some((other) => other.stroke === stroke && other.end === end),
  )
}
