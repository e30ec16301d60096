import { STROKE_DEFAULTS, type Stroke } from '../document.ts'
import { distanceToLine, type Fork } from './forks.ts'
import { insertPoint } from './points.ts'
import { splitStroke } from './split.ts'
import type { StrokeLine, StrokeLines } from './stroke-lines.ts'

/** Minimum length to cut off a stroke, and minimum distance of the new end from the other strokes of the fork, in millimetres. */
const GAP = 2
/** Maximum fraction of a stroke's length to cut off, even if the new end is then nearer to the other strokes than `GAP`. */
const MAX_FRACTION = 0.5

/**
 * Shortens a stroke (a wrinkle) at the ends that are in forks, so that it leaves the forks. A new end fades like the other end, or like the ends
 * of new strokes if the other end does not fade.
 *
 * @param index index of the stroke in `strokes`.
 * @param forks forks of `strokes` to leave. Forks without an end of the stroke are ignored.
 * @returns the stroke, converted to a spline by `splineOf`.
 */
export function detachStroke<S extends Stroke>(
  strokes: readonly S[],
  index: number,
  forks: readonly Fork[],
  lines: StrokeLines,
): S {
  return forks.reduce((stroke, { ends, trunks }) => {
    const own = ends.find((each) => each.stroke === index)
    const line = lines.lineOf(stroke)
    if (!own || !line) return stroke
    const others = [...ends, ...trunks].filter((each) => each.stroke !== index)
    const otherLines = others.flatMap((each) => lines.lineOf(strokes[each.stroke]) ?? [])
    return withoutEnd(stroke, own.end, cutOf(line, own.end, otherLines), lines)
  }, strokes[index])
}

/** Cuts off a fraction of a stroke at an end. */
function withoutEnd<S extends Stroke>(stroke: S, end: 0 | 1, fraction: number, { skin }: StrokeLines): S {
  const cut = insertPoint(stroke, end === 0 ? fraction : 1 - fraction, skin)
  // Without a new point, an existing point is at the cut.
  const index = cut.index >= 0 ? cut.index : end === 0 ? 1 : cut.stroke.points.length - 2
  const part = splitStroke(cut.stroke, index, skin)[1 - end]
  const fade = stroke.taper[1 - end] || STROKE_DEFAULTS.taper[end]
  return { ...part, taper: end === 0 ? [fade, part.taper[1]] : [part.taper[0], fade] }
}

/** Returns the fraction of a line to cut off at an end. */
function cutOf({ points, lengths }: StrokeLine, end: 0 | 1, others: readonly StrokeLine[]): number {
  const total = lengths[lengths.length - 1]
  for (let i = 0; i < lengths.length; i++) {
    const at = end === 0 ? i : lengths.length - 1 - i
    const length = end === 0 ? lengths[at] : total - lengths[at]
    if (length > MAX_FRACTION * total) break
    const position = points.subarray(3 * at, 3 * at + 3)
    if (length >= GAP && others.every((other) => distanceToLine(other, position) >= GAP))
      return length / total
  }
  return MAX_FRACTION
}
