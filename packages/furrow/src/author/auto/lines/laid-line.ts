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
}

/** Minimum number of points of a line: start, middle and end. */
export const MIN_POINTS = 3
