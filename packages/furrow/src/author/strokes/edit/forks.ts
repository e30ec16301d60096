import { distanceToSegment } from '../../../math/spline.ts'
import { dot, length3 } from '../../../math/vector.ts'
import { barycentricsAt, normalAt } from '../../skin/walk.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { isBulge } from '../lay-out.ts'
import { FACING } from '../line-segments.ts'
import { boxAround } from '../placed-stroke.ts'
import type { StrokeLine, StrokeLines } from './stroke-lines.ts'

/** Maximum distance in millimetres between a stroke's end and another stroke that meet in a fork. */
export const TOUCH = 0.5

/** Start or end of a stroke. */
export interface StrokeEnd {
  /** Index of the stroke. */
  stroke: number
  /** 0: start, 1: end. */
  end: 0 | 1
}

/** Stroke that continues on both sides of a fork. */
export interface Trunk {
  /** Index of the stroke. */
  stroke: number
  /** Index of the point of the stroke's line (`StrokeLine`) at the fork. */
  place: number
}

/** Place where strokes (wrinkles) meet: at least one end, and another end or a trunk. */
export interface Fork {
  ends: readonly StrokeEnd[]
  trunks: readonly Trunk[]
}

/** Strokes and their forks. */
export interface ForkedStrokes<S extends Stroke> {
  strokes: readonly S[]
  /** Result of `findForks`. */
  forks: readonly Fork[]
  lines: StrokeLines
}

/** Line with the data of a search: its index and its bounding box, widened by `TOUCH`. */
interface Searched {
  stroke: number
  layer: string | undefined
  isRaised: boolean
  line: StrokeLine
  box: Float64Array
}

/** Fork that is being collected. `position` is the position of its first end. */
interface Found {
  position: Float64Array
  ends: StrokeEnd[]
  trunks: Trunk[]
}

/** Finds the forks of strokes. Forks are computed from positions alone, so an end leaves its fork when the end is moved away. */
export function findForks(strokes: readonly Stroke[], lines: StrokeLines): Fork[] {
  const searched = strokes.flatMap((each, stroke): Searched[] => {
    const line = lines.lineOf(each)
    return line
      ? [{ stroke, layer: each.layer, isRaised: isBulge(each), line, box: boxAround([line], () => TOUCH) }]
      : []
  })
  const forks: Found[] = []
  for (const own of searched) {
    for (const end of [0, 1] as const) {
      const at = end === 0 ? 0 : own.line.triangles.length - 1
      const position = pointAt(own.line, at)
      for (const other of searched) {
        if (other === own || !canMeet(own, other) || !isInside(position, other.box)) continue
        const place = nearestPlace(other.line, position)
        if (place < 0 || !facesAlike(own.line, at, other.line, place, lines.skin)) continue
        addContact(forkAt(forks, position), { stroke: own.stroke, end }, other, place)
      }
    }
  }
  return forks.map(({ ends, trunks }) => ({ ends, trunks }))
}

/** Whether two strokes are drawn as one if they touch: in the same layer, both as valleys or both as bulges. */
function canMeet(a: Searched, b: Searched): boolean {
  return a.layer === b.layer && a.isRaised === b.isRaised
}

/** Returns the end of a line if a place is at most `TOUCH` away from it, measured along the line. Otherwise, returns undefined. */
function endAt({ lengths }: StrokeLine, place: number): 0 | 1 | undefined {
  if (lengths[place] <= TOUCH) return 0
  return lengths[lengths.length - 1] - lengths[place] <= TOUCH ? 1 : undefined
}

/** Adds an end to a fork, and the stroke that it touches: as an end if it is touched at its end, as a trunk otherwise. */
function addContact(
  { ends, trunks }: Found,
  end: StrokeEnd,
  { stroke, line }: Searched,
  place: number,
): void {
  addEnd(ends, end)
  const touched = endAt(line, place)
  if (touched !== undefined) addEnd(ends, { stroke, end: touched })
  else if (trunks.every((trunk) => trunk.stroke !== stroke)) trunks.push({ stroke, place })
}

/**
 * Adds an end, unless the fork has an end of the same stroke. With both ends of a short stroke, moving the fork would collapse the stroke to a
 * point.
 */
function addEnd(ends: StrokeEnd[], end: StrokeEnd): void {
  if (ends.every(({ stroke }) => stroke !== end.stroke)) ends.push(end)
}

/** Returns the fork at a position. Adds it if there is none. */
function forkAt(forks: Found[], position: Float64Array): Found {
  const known = forks.find((fork) => distance(fork.position, position) <= TOUCH)
  if (known) return known
  const fork: Found = { position, ends: [], trunks: [] }
  forks.push(fork)
  return fork
}

/** Returns the index of the line's point nearest to a position, or -1 if the line is farther away than `TOUCH`. */
function nearestPlace(line: StrokeLine, position: Float64Array): number {
  if (distanceToLine(line, position) > TOUCH) return -1
  let [nearest, least] = [-1, Infinity]
  for (let i = 0; i < line.triangles.length; i++) {
    const own = distance(pointAt(line, i), position)
    if (own < least) [nearest, least] = [i, own]
  }
  return nearest
}

/** Returns the distance from a position to a line in millimetres. */
export function distanceToLine({ points }: StrokeLine, position: Float64Array): number {
  let least = Infinity
  for (let i = 0; 3 * i + 3 < points.length; i++)
    least = Math.min(least, distanceToSegment(points, i, position))
  return least
}

/** Whether the skin faces similar directions at points of two lines. Lips touch, but their lines do not meet. */
function facesAlike(a: StrokeLine, i: number, b: StrokeLine, j: number, skin: LocatedSkin): boolean {
  return dot(normalOf(a, i, skin), normalOf(b, j, skin)) >= FACING
}

function normalOf(line: StrokeLine, i: number, { surface }: LocatedSkin): Float64Array {
  const [weights, normal] = [new Float64Array(3), new Float64Array(3)]
  barycentricsAt(weights, surface, line.triangles[i], pointAt(line, i))
  normalAt(normal, surface, line.triangles[i], weights)
  return normal
}

/** Returns xyz of a point of a line. */
export function pointAt({ points }: StrokeLine, i: number): Float64Array {
  return points.subarray(3 * i, 3 * i + 3)
}

function distance(a: Float64Array, b: Float64Array): number {
  return length3(a[0] - b[0], a[1] - b[1], a[2] - b[2])
}

function isInside(position: Float64Array, box: Float64Array): boolean {
  return position.every((value, k) => value >= box[k] && value <= box[3 + k])
}
