import { lerp } from '../../../math/scalar.ts'
import type { Stroke, Uv } from '../document.ts'
import { type Fork, type ForkedStrokes, TOUCH } from './forks.ts'
import { grabPoint, withPoint } from './grab.ts'
import { insertPoint } from './points.ts'
import { splineOf } from './spline-of.ts'
import type { StrokeLine, StrokeLines } from './stroke-lines.ts'
import { uvOf } from './traced-stroke.ts'

/** Changed strokes. The keys are their indices. */
export type ChangedStrokes<S extends Stroke> = Map<number, S>

/** Adds a control point at a fork to each trunk that has none there. `moveFork` moves these points. Adding them moves the lines by at most 0.1 mm. */
export function withForkPoints<S extends Stroke>(
  strokes: readonly S[],
  { trunks }: Fork,
  lines: StrokeLines,
): readonly S[] {
  return trunks.reduce((all: readonly S[], { stroke, place }) => {
    const line = lines.lineOf(all[stroke])
    if (!line || knotAt(line, place) >= 0) return all
    const along = line.lengths[place] / line.lengths[line.lengths.length - 1]
    return all.with(stroke, insertPoint(all[stroke], along, lines.skin).stroke)
  }, strokes)
}

/** Returns the index of the spline's point that is nearest to a place of its line and at most `TOUCH` away, or -1. */
export function knotAt({ lengths, knots }: StrokeLine, place: number): number {
  let [nearest, least] = [-1, TOUCH]
  for (const [knot, at] of knots.entries()) {
    const apart = Math.abs(lengths[at] - lengths[place])
    if (apart > least) continue
    nearest = knot
    least = apart
  }
  return nearest
}

/**
 * Moves all strokes that meet in a fork: their ends, and the points of its trunks (`withForkPoints`).
 *
 * @param uv new position of the fork.
 * @param radius arc length up to which neighbouring points move too, millimetres.
 */
export function moveFork<S extends Stroke>(
  forked: ForkedStrokes<S>,
  fork: Fork,
  uv: Uv,
  radius = 0,
): ChangedStrokes<S> {
  const { strokes, lines } = forked
  const changed: ChangedStrokes<S> = new Map()
  const move = (stroke: number, knot: number) =>
    changed.set(stroke, grabPoint(forked, stroke, knot, { uv, radius, moved: fork }))
  for (const { stroke, end } of fork.ends) move(stroke, endKnot(strokes[stroke], end, lines))
  for (const { stroke, place } of fork.trunks) {
    const line = lines.lineOf(strokes[stroke])
    const knot = line ? knotAt(line, place) : -1
    if (knot >= 0) move(stroke, knot)
  }
  return pullBranches(forked, changed)
}

function withEnd<S extends Stroke>(stroke: S, end: 0 | 1, uv: Uv, lines: StrokeLines): S {
  return withPoint(stroke, endKnot(stroke, end, lines), uv, lines)
}

/** Returns the index of a stroke's first or last point in its spline. */
function endKnot(stroke: Stroke, end: 0 | 1, { skin }: StrokeLines): number {
  return end === 0 ? 0 : splineOf(stroke, skin).points.length - 1
}

/**
 * Moves the branches of changed strokes, so that they stay attached. A branch attached between two control points of the trunk keeps its
 * fraction of the arc length between them. Branches of branches follow as well.
 *
 * @param forked all strokes before the change.
 * @param changed changed strokes. Their splines have as many points as before, or lack the point `removed`.
 * @param removed index of a point that was removed from the spline of each changed stroke.
 * @returns the changed strokes and their branches.
 */
export function pullBranches<S extends Stroke>(
  { strokes, forks, lines }: ForkedStrokes<S>,
  changed: ReadonlyMap<number, S>,
  removed = -1,
): ChangedStrokes<S> {
  const all: ChangedStrokes<S> = new Map(changed)
  const moved = new Set<string>()
  const queue = [...changed.keys()]
  for (const index of queue) {
    const [before, after] = [lines.lineOf(strokes[index]), lines.lineOf(all.get(index) ?? strokes[index])]
    if (!before || !after) continue
    const knots = changed.has(index) ? before.knots.filter((_, knot) => knot !== removed) : before.knots
    for (const { ends, trunks } of forks) {
      const trunk = trunks.find(({ stroke }) => stroke === index)
      const place = trunk ? placeAfter(before, knots, after, trunk.place) : -1
      if (place < 0) continue
      for (const { stroke, end } of ends) {
        const key = `${stroke} ${end}`
        if (moved.has(key) || isMoved(strokes[stroke], all.get(stroke), end)) continue
        moved.add(key)
        all.set(
          stroke,
          withEnd(all.get(stroke) ?? strokes[stroke], end, uvOf(after, place, lines.skin), lines),
        )
        queue.push(stroke)
      }
    }
  }
  return all
}

/** Returns whether the given end of a stroke has moved. */
function isMoved(before: Stroke, after: Stroke | undefined, end: 0 | 1): boolean {
  const [old, now] = [before, after ?? before].map(({ points }) => points[end * (points.length - 1)])
  return old[0] !== now[0] || old[1] !== now[1]
}

/**
 * Returns the place of a changed line that corresponds to a place of the line before, or -1 if the changed line does not reach it.
 *
 * @param knots places of the spline's points on the line before, without removed points.
 */
function placeAfter(before: StrokeLine, knots: readonly number[], after: StrokeLine, place: number): number {
  const next = knots.findIndex((knot) => knot >= place)
  if (next < 0 || knots.length !== after.knots.length || (next === 0 && knots[0] > place)) return -1
  if (next === 0) return after.knots[0]
  const [start, end] = [before.lengths[knots[next - 1]], before.lengths[knots[next]]]
  const fraction = end > start ? (before.lengths[place] - start) / (end - start) : 0
  const length = lerp(after.lengths[after.knots[next - 1]], after.lengths[after.knots[next]], fraction)
  return nearestAt(after.lengths, length)
}

/** Returns the index of the value nearest to `length` in a sorted list. */
function nearestAt(lengths: Float64Array, length: number): number {
  const above = lengths.findIndex((each) => each >= length)
  if (above < 0) return lengths.length - 1
  return above > 0 && length - lengths[above - 1] < lengths[above] - length ? above - 1 : above
}
