import { clamp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import { Relief } from '../buckling/relief.ts'
import { sampleAt } from '../buckling/sample-chart.ts'
import { traceValleys } from '../buckling/valleys.ts'
import { type BuckledCloth, SOLVED } from './cloth-film.ts'

/** Crest of a fold on the chart. */
export interface Ridge {
  /** Packed x, y in millimetres from the first sample. */
  points: Float64Array
  /** Height above the valleys beside it at each point, in millimetres. */
  heights: Float64Array
  /** Distances to the valleys on both sides in millimetres. Left is towards +y if the ridge runs along +x. */
  reach: readonly [left: number, right: number]
  /** Whether the ridge joins another one at its first and at its last point. */
  joins: readonly [first: boolean, last: boolean]
}

/** Distance between points of a ridge, in wavelengths of `SOLVED`. */
const STEP = 0.06
/** Minimum height of a ridge above the mean, in wavelengths. */
const MIN_HEIGHT = 0.008
/** Minimum weight of the compression at a ridge. */
const MIN_WEIGHT = 0.12
/** Range in which valleys are sought, and range of the reach of a fold, in wavelengths. */
const RANGE = 0.8
const REACH = [0.36, 0.68] as const
/** Number of samples on each side of a ridge, to find the valley. */
const LOOKUPS = 20

/**
 * Traces the crests of folds.
 *
 * @param shortest minimum length of a crest in wavelengths.
 */
export function traceRidges(
  { samples, heights, weight, wavelength }: BuckledCloth,
  { wavelength: lambda, shortest }: { wavelength: number; shortest: number },
): Ridge[] {
  const scale = SOLVED / lambda
  const grid = { ...samples.grid, spacing: scale * samples.grid.spacing }
  // Valleys of the inverted relief are ridges.
  const relief = new Relief(
    grid,
    heights.map((height) => -scale * height),
  )
  const sample = (x: number, y: number) => sampleAt(samples, x / scale, y / scale)
  const found = traceValleys(relief, {
    step: STEP * SOLVED,
    wavelength: (x, y) => scale * wavelength[sample(x, y)],
    isInside: (x, y) => weight[sample(x, y)] > MIN_WEIGHT,
    minDepth: MIN_HEIGHT * SOLVED,
    minLength: shortest * SOLVED,
  })
  return found.map(({ points, depths, joins }) => ({
    points: Float64Array.from(points, (value) => value / scale),
    heights: Float64Array.from(depths, (depth) => depth / scale),
    reach: reachesOf(relief, points).map((reach) =>
      clamp(reach / scale, REACH[0] * lambda, REACH[1] * lambda),
    ) as [number, number],
    joins,
  }))
}

/** Returns the median distances from a ridge to the valleys on its left and on its right. */
function reachesOf(relief: Relief, points: readonly number[]): [left: number, right: number] {
  const sides: [number[], number[]] = [[], []]
  for (let i = 2; i + 3 < points.length; i += 4) {
    const [dx, dy] = [points[i + 2] - points[i - 2], points[i + 3] - points[i - 1]]
    const size = length2(dx, dy) || 1
    for (const [k, sign] of [
      [0, -1],
      [1, 1],
    ] as const) {
      let [lowest, at] = [-Infinity, RANGE * SOLVED]
      for (let n = 1; n <= LOOKUPS; n++) {
        const distance = (n * RANGE * SOLVED) / LOOKUPS
        const { height } = relief.at(
          points[i] + (sign * distance * dy) / size,
          points[i + 1] - (sign * distance * dx) / size,
        )
        if (height < lowest) break
        ;[lowest, at] = [height, distance]
      }
      sides[k].push(at)
    }
  }
  return sides.map((side) => side.sort((a, b) => a - b)[side.length >> 1] ?? 0.5 * SOLVED) as [number, number]
}
