import { signal } from '@preact/signals'
import { insertPoint, removePoint, type Uv } from 'furrow/author'
import { grabWeights, heldEnds, splineOf } from 'furrow/internal'
import type { StudioDocument } from '../document/document.ts'
import { replaceStrokes } from '../document/strokes.ts'
import { STEP } from '../labels/steps.ts'
import { coverMoved } from './line-area.ts'
import type { LineEdits } from './line-edits.ts'
import { PointMove } from './point-move.ts'

/** Range of `LinePoints.reach`, and its default, millimetres. */
export const REACH_RANGE = [0, 60] as const
const REACH = 15
/** Minimum distance from all points at which a dragged line gets a new point, millimetres. It also depends on the reach. */
const NEAR = 4
/** Change of `LinePoints.reach` per key press, millimetres. */
const REACH_STEP = 2.5

/** Moves, adds and removes points of the chosen lines. */
export class LinePoints {
  /** Distance along the line up to which a moved point takes its neighbours along, millimetres. 0: it moves alone. */
  readonly reach = signal(REACH)
  readonly #edits: LineEdits
  /** Current gesture that moves a point, or null. */
  #move: PointMove | null = null
  /** Indices of the lines that the current gesture has changed. */
  #moved: ReadonlySet<number> = new Set()

  constructor(edits: LineEdits) {
    this.#edits = edits
  }

  /** Whether the current gesture has changed a line. @param index index of the line in the document. */
  isMoving(index: number): boolean {
    return this.#moved.has(index)
  }

  /** Returns the fraction of a handle's motion that each handle would make. @param index index of the moved handle. */
  grabWeights(index: number): readonly number[] {
    const { selection, surface } = this.#edits
    const [handles, stroke] = [selection.handles.peek(), selection.main.peek()]
    const line = stroke && surface?.lines.lineOf(stroke)
    const moved = handles[index]
    if (!line || !moved) return []
    const places = { lengths: line.lengths, knots: handles.map(({ place }) => place) }
    const held = heldEnds(selection.forks.peek(), selection.index, moved.fork)
    return grabWeights(places, index, this.reach.peek(), held)
  }

  /**
   * Moves the chosen point of the main line, and points near it; a fork with all lines that meet there. Moves the other chosen lines alike. All
   * moves until `settle` are one undo step.
   *
   * @param isAlone whether no neighbouring points move, whatever `reach` is.
   */
  move(uv: Uv, isAlone = false): void {
    this.#moveTo(() => uv, isAlone)
  }

  /** Moves the chosen point like `move`, by the motion of the pointer from one place to another. */
  drag(from: Uv, to: Uv, isAlone = false): void {
    this.#moveTo((move) => move.follow(from, to), isAlone)
  }

  #moveTo(target: (move: PointMove) => Uv | null, isAlone: boolean): void {
    const { selection, session, surface } = this.#edits
    const { handle, indices } = selection
    const strokes = session.document.peek()?.strokes
    if (!handle || !surface || !strokes) return
    if (this.#move?.last !== strokes) this.#move = new PointMove(strokes, indices, handle, surface.lines)
    const uv = target(this.#move)
    if (!uv) return
    const moved = this.#move.to(uv, isAlone ? 0 : this.reach.peek())
    const changed = this.#edits.withCounterparts(moved, strokes)
    this.#moved = new Set(changed.keys())
    session.edit(this.#move.label, (old) => replaceStrokes(old, changed), this.#edits.keyOf('points'))
    this.#move.last = session.document.peek()!.strokes
  }

  /**
   * Adds a point to the main line and chooses the point. The addition and all moves of the point until `settle` are one undo step.
   *
   * @param along position on the line, 0..1.
   */
  insert(along: number): void {
    let index = -1
    this.#edits.replaceMain(
      STEP.addPoint,
      (stroke, { canvas }) => {
        const inserted = insertPoint(stroke, along, canvas)
        index = inserted.index
        return [inserted.stroke]
      },
      'points',
    )
    const { point, handles } = this.#edits.selection
    if (index >= 0) point.value = handles.peek().findIndex(({ knot }) => knot === index)
  }

  /** Chooses the handle of the main line that is nearest to a place. If none is near, adds a point there. @param along place on the line, 0..1. */
  chooseNear(along: number): void {
    const { selection, surface } = this.#edits
    const stroke = selection.main.peek()
    const line = stroke && surface?.lines.lineOf(stroke)
    if (!line) return
    const total = line.lengths[line.lengths.length - 1]
    const apart = selection.handles.peek().map(({ place }) => Math.abs(line.lengths[place] - along * total))
    const least = Math.min(...apart)
    if (least <= Math.max(this.reach.peek() / 2, NEAR)) selection.point.value = apart.indexOf(least)
    else this.insert(along)
  }

  /** Removes the chosen point. Returns false if the line must be removed instead, because no point is chosen or it has only two. */
  remove(): boolean {
    const { selection, surface } = this.#edits
    const { knot = -1, fork } = selection.handle ?? {}
    const stroke = selection.main.peek()
    const canvas = surface?.canvas
    // A fork between two points of the chosen line has no point to remove: it is the end of another line.
    if (!stroke || !canvas || (fork && knot < 0)) return true
    selection.point.value = -1
    if (knot < 0 || splineOf(stroke, canvas).points.length <= 2) return false
    this.#edits.changeTrunks(STEP.removePoint, [selection.index], () => removePoint(stroke, knot, canvas), {
      removed: knot,
    })
    return true
  }

  /** Ends a gesture. If it moved points out of the areas of their lines, extends the areas to keep the lines visible. */
  settle(): void {
    if (this.#move) this.#cover(this.#move)
    this.#move = null
    this.#moved = new Set()
  }

  /** Extends areas to the moved points, in the same undo step as the move. */
  #cover(move: PointMove): void {
    const { session, surface } = this.#edits
    if (!surface) return
    const cover = (document: StudioDocument) =>
      [...this.#moved].reduce((covered, index) => {
        const handle = move.hasHandle(index) ? move.uv : null
        return coverMoved(covered, document.strokes[index], move.first[index], handle, surface.canvas)
      }, document)
    session.edit(move.label, cover, this.#edits.keyOf('points'))
  }
}

/** Returns `LinePoints.reach` after a key press. */
export function nextReach(reach: number, change: 'smaller' | 'larger'): number {
  const next = reach + (change === 'larger' ? REACH_STEP : -REACH_STEP)
  return Math.min(Math.max(next, REACH_RANGE[0]), REACH_RANGE[1])
}
