import { type Fork, knotAt, type StrokeLine } from 'furrow/internal'

/** Point of a line that can be moved: a point of the line's spline, or a fork. */
export interface Handle {
  /** Index of the line's point (`StrokeLine`) at the handle. */
  readonly place: number
  /** Index of the spline's point, or -1 at a fork between two points. */
  readonly knot: number
  /** Fork whose lines move with the handle, or null. */
  readonly fork: Fork | null
}

/**
 * Returns the handles of a line, from its start to its end.
 *
 * @param index index of the line's stroke in the document.
 * @param forks forks of all strokes.
 */
export function handlesOf(index: number, line: StrokeLine, forks: readonly Fork[]): Handle[] {
  const handles: Handle[] = line.knots.map((place, knot) => ({ place, knot, fork: null }))
  for (const fork of forks) {
    const trunk = fork.trunks.find(({ stroke }) => stroke === index)
    const end = fork.ends.find(({ stroke }) => stroke === index)
    const knot = end ? end.end * (line.knots.length - 1) : trunk ? knotAt(line, trunk.place) : -1
    if (knot >= 0) handles[knot] = { ...handles[knot], fork }
    else if (trunk) handles.push({ place: trunk.place, knot, fork })
  }
  return handles.sort((a, b) => a.place - b.place)
}
