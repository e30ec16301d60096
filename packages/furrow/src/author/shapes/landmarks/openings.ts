import { quantile } from '../../../math/quantile.ts'
import { interpolated, type Vector } from '../vectors.ts'
import { type FaceFrame, positionInFrame } from './face-frame.ts'

/** Positions of samples along a lid or a lip, from one corner (-1) to the other (1). */
export const ALONG = Array.from({ length: 17 }, (_, i) => -1 + i / 8)

/** Line between the lips, in coordinates of `FaceFrame`. */
export interface LipLine {
  halfWidth: number
  /** Coordinate v of the line at each position in `ALONG`. */
  heights: number[]
}

/** Opening of the left eye in coordinates of `FaceFrame`; the right eye is its mirror image. */
export interface EyeOpening {
  /** Coordinate u of the centre. */
  middle: number
  halfWidth: number
  /** Coordinate v of the upper lid's edge at each position in `ALONG`. */
  upper: number[]
  /** Coordinate v of the lower lid's edge at each position in `ALONG`. */
  lower: number[]
}

// The lip line is searched from u = 0 to `REACH`, in columns of equal width. Both halves of the face are combined.
const COLUMNS = 16
const REACH = 1.6
const COLUMN = REACH / COLUMNS

/** Traces the lip line from the middle to the corner of the mouth. In each column, it passes through the foremost points of `LipSeam`. */
export function lipLine(frame: FaceFrame): LipLine {
  const standard: LipLine = { halfWidth: 0.8, heights: ALONG.map(() => -2) }
  if (!frame.seam) return standard
  const points = frame.seam.points
    .map((point) => positionInFrame(frame, point))
    .filter(([u, v]) => Math.abs(v + 2) < 0.6 && Math.abs(u) < REACH)
  const found: { middle: number; end: number; front: number; height: number }[] = []
  for (let k = 0; k < COLUMNS; k++) {
    const [start, end] = [k * COLUMN, (k + 1) * COLUMN]
    const column = points.filter(([u]) => Math.abs(u) >= start - 0.03 && Math.abs(u) < end + 0.03)
    if (column.length < 2) {
      if (k > 2) break
      continue
    }
    const front = column.reduce((most, [, , z]) => Math.max(most, z), -Infinity)
    // Beyond the corner of the mouth, the points of `LipSeam` are inside the mouth, farther back.
    if (found.length > 0 && front < found[found.length - 1].front - 0.35) break
    const outer = column.filter(([, , z]) => z > front - 0.12).map(([, v]) => v)
    found.push({ middle: start + COLUMN / 2, end, front, height: quantile(outer, 0.5) })
  }
  const halfWidth = (found.at(-1)?.end ?? 0) - 0.03
  if (found.length < 3 || halfWidth < 0.25) return standard
  const [xs, ys] = [found.map(({ middle }) => middle), found.map(({ height }) => height)]
  return { halfWidth, heights: ALONG.map((a) => interpolated(Math.abs(a) * halfWidth, xs, ys)) }
}

/** Models an eye opening as an ellipse around points on the edges of the lids. Targets that close the eye bring these points together. */
export function eyeOpening(frame: FaceFrame): EyeOpening {
  const lids = frame.closing
    .map(({ first, second }) => [first, second].map((end) => positionInFrame(frame, end)))
    .filter((ends) => ends.every(([u, v]) => Math.abs(Math.abs(u) - 1) < 0.75 && Math.abs(v) < 0.9))
  if (lids.length < 8)
    return { middle: 1, halfWidth: 0.45, upper: ALONG.map(() => 0.14), lower: ALONG.map(() => -0.14) }
  const us = lids.map(([a, b]) => (Math.abs(a[0]) + Math.abs(b[0])) / 2)
  const top = quantile(
    lids.map(([a, b]) => Math.max(a[1], b[1])),
    0.8,
  )
  const bottom = quantile(
    lids.map(([a, b]) => Math.min(a[1], b[1])),
    0.2,
  )
  const [low, high] = [quantile(us, 0.03), quantile(us, 0.97)]
  const [middle, half] = [(top + bottom) / 2, (top - bottom) / 2]
  const arch = ALONG.map((a) => Math.sqrt(1 - (0.94 * a) ** 2))
  return {
    middle: (low + high) / 2,
    halfWidth: Math.max((high - low) / 2, 0.25),
    upper: arch.map((a) => middle + half * a),
    lower: arch.map((a) => middle - half * a),
  }
}

/** A target closes an eye if it brings together at least this number of pairs of points at the eye (`ClosingPair`). */
const CLOSED = 9
/** The number of pairs must also exceed this fraction of the largest number of pairs that any target brings together. */
const CLOSED_FRACTION = 0.08

/** Returns, for each target in `MovingSurface.motions`, whether it closes the lids of the left and of the right eye. */
export function closedEyes(frame: FaceFrame, motions: number): readonly (readonly [boolean, boolean])[] {
  const counts = Array.from({ length: motions }, () => [0, 0])
  for (const { first, second, motion } of frame.closing) {
    const [a, b] = [first, second].map((end): Vector => positionInFrame(frame, end))
    const isAtEye = [a, b].every(([u, v]) => Math.abs(Math.abs(u) - 1) < 0.75 && Math.abs(v) < 0.9)
    if (isAtEye) counts[motion][a[0] + b[0] > 0 ? 0 : 1]++
  }
  const most = Math.max(...counts.flat(), 0)
  const isClosed = (count: number) => count >= CLOSED && count > CLOSED_FRACTION * most
  return counts.map(([left, right]) => [isClosed(left), isClosed(right)] as const)
}
