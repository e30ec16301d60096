import type { LineStyle } from '../anatomy/region.ts'

/** Wrinkle line laid on the skin. */
export interface LaidLine {
  style: LineStyle
  /** Packed xyz in millimetres. */
  points: Float64Array
  /** Triangle of the surface at each point. */
  triangles: readonly number[]
  /** Fraction of length that the skin loses across the line at each point; negative if the skin is stretched. */
  compressions: readonly number[]
  /** Depth at each point, as a fraction of `style.depth`, 0..1. Default: derived from compression and random noise. */
  relativeDepths?: readonly number[]
}

/** Minimum number of points of a line: start, middle and end. */
export const MIN_POINTS = 3

/**
 * Splits a line at the points that it loses.
 *
 * @param count number of points.
 * @param isKept returns whether the line keeps the point at an index.
 * @returns first index and end index (exclusive) of each part with at least `MIN_POINTS` points.
 */
export function keptRuns(count: number, isKept: (i: number) => boolean): [start: number, end: number][] {
  const runs: [start: number, end: number][] = []
  for (let start = 0; start < count; ) {
    let end = start
    while (end < count && isKept(end)) end++
    if (end - start >= MIN_POINTS) runs.push([start, end])
    start = end + 1
  }
  return runs
}
