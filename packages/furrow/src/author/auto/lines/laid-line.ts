import type { LineStyle } from '../anatomy/region.ts'

/** A line on the skin. */
export interface LaidLine {
  style: LineStyle
  /** x, y and z of each point, in millimetres. */
  points: Float64Array
  /** The triangle of each point. */
  triangles: readonly number[]
  /** Fraction of its length that the skin loses across the line at each point; below 0 where it is stretched. */
  compressions: readonly number[]
}

/** A beginning, a middle and an end. */
export const MIN_POINTS = 3
