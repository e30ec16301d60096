import type { ChartPoint } from '../surface/head-chart.ts'
import { chartPointOf, type EyeOpening, type FaceContext, type Side } from './region.ts'

/** Distances in millimetres from the centre of the closed lids in which the opening is searched, and the step. */
const SEARCHED = { above: 4, below: 18, step: 0.5 } as const
/** Distances in millimetres around the corners of the lids in which the opening is searched. */
const BESIDE = 4
/** Number of times that the distance between a point on the skin and one in the opening is halved to find the edge. */
const HALVINGS = 6
/** Rows whose ends are within this distance of the outermost end, in millimetres, determine the height of a corner. */
const CORNER = 1
/** Minimum width of an opening in millimetres. */
const MIN_WIDTH = 12
/** Usual offsets of the corners and the margin from the landmarks, in millimetres, if the mesh has no hole at the eye. */
const USUAL = { inner: [6.5, -3], outer: [-2, -4], margin: -9 } as const

/** Horizontal section of the opening. */
interface Row {
  up: number
  inner: number
  outer: number
  /** Distances from the middle of the face of the samples in the opening. */
  open: readonly number[]
}

/**
 * Finds the opening of an eye: the hole of the skin between the lids. The landmarks at the corners are those of the lids, which are wider. The
 * result changes continuously with the positions of the vertices, so that a compressed file gets the same lines.
 */
export function eyeOpening(
  { landmarks, radiusAt }: Pick<FaceContext, 'landmarks' | 'radiusAt'>,
  side: Side,
): EyeOpening {
  const eye = landmarks.eye[1]
  const [inner, innerUp] = chartPointOf(landmarks.innerCorner)
  const [outer, outerUp] = chartPointOf(landmarks.outerCorner)
  const isOpen = (across: number, up: number) => radiusAt([side * across, up]) === undefined
  const rows: Row[] = []
  for (let up = eye + SEARCHED.above; up >= eye - SEARCHED.below; up -= SEARCHED.step) {
    const open: number[] = []
    for (let across = inner - BESIDE; across <= outer + BESIDE; across += SEARCHED.step) {
      if (isOpen(across, up)) open.push(across)
    }
    if (open.length === 0) continue
    const [first, last] = [open[0], open[open.length - 1]]
    rows.push({
      up,
      inner: edge(first, first - SEARCHED.step, (across) => isOpen(across, up)),
      outer: edge(last, last + SEARCHED.step, (across) => isOpen(across, up)),
      open,
    })
  }
  const lowestRow = rows.at(-1)
  const corners = lowestRow && { inner: cornerOf(rows, 'inner', 1), outer: cornerOf(rows, 'outer', -1) }
  if (corners && corners.outer[0] - corners.inner[0] >= MIN_WIDTH) {
    const { up, open } = lowestRow
    const ends = open.map((across) => edge(up, up - SEARCHED.step, (below) => isOpen(across, below)))
    return { ...corners, lowest: Math.min(...ends) }
  }
  return {
    inner: [inner + USUAL.inner[0], innerUp + USUAL.inner[1]],
    outer: [outer + USUAL.outer[0], outerUp + USUAL.outer[1]],
    lowest: eye + USUAL.margin,
  }
}

/** Returns the edge of the opening between a coordinate inside it and one outside. */
function edge(inside: number, outside: number, isOpen: (coordinate: number) => boolean): number {
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (inside + outside) / 2
    if (isOpen(middle)) inside = middle
    else outside = middle
  }
  return inside
}

/** Returns a corner of the opening. `sign` is 1 for the corner with the smallest coordinate, -1 for that with the largest. */
function cornerOf(rows: readonly Row[], end: 'inner' | 'outer', sign: 1 | -1): ChartPoint {
  const across = sign * Math.min(...rows.map((row) => sign * row[end]))
  let [sum, weights] = [0, 0]
  for (const row of rows) {
    const weight = Math.max(0, 1 - Math.abs(row[end] - across) / CORNER)
    sum += weight * row.up
    weights += weight
  }
  return [across, sum / weights]
}
