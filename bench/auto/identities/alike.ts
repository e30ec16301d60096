import { mean } from '../../statistics.ts'

/** Point of a line in a flat chart of the skin, millimetres. */
export type FlatPoint = readonly [x: number, y: number]

/** Points of the lines of two patterns, in one chart, which shows a part of the skin. The points of a line are evenly spaced, at most 1 mm apart. */
export interface Comparison {
  lines: readonly FlatPoint[]
  others: readonly FlatPoint[]
}

/** Maximum distance of two points that count as the same, millimetres. */
const SAME = 1.5
/** Distances, in millimetres, by which patterns are shifted against each other. Points that are still the same after the shift match by chance. */
const SHIFTS = [3, 5.5, 8]
/** Number of directions in which patterns are shifted by each distance. */
const DIRECTIONS = 16

/**
 * Measures how alike two patterns of lines are: k = (share - chance) / (1 - chance). The share is the fraction of the first pattern's points
 * that are within 1.5 mm of the second pattern. To measure chance, one pattern is shifted by 3 to 8 mm in many directions. Chance is the mean
 * share of the shifted patterns. The measure has the form of Cohen's kappa (Cohen 1960, Educ Psychol Meas 20).
 *
 * @param parts comparisons of different parts of the skin, pooled into one measure. Parts in which one pattern has no points are skipped.
 * @returns 1 for identical patterns, about 0 for unrelated ones. Undefined if all parts are skipped, or if chance is 1.
 */
export function alikeness(parts: readonly Comparison[]): number | undefined {
  const filled = parts.filter(({ lines, others }) => lines.length > 0 && others.length > 0)
  if (filled.length === 0) return undefined
  const covered = filled.map(({ lines, others }) => ({ lines, cover: new Cover(others) }))
  const shareAt = (dx: number, dy: number) => {
    const near = covered.flatMap(({ lines, cover }) => lines.map(([x, y]) => cover.has(x + dx, y + dy)))
    return near.filter(Boolean).length / near.length
  }
  const shifted = SHIFTS.flatMap((distance) =>
    Array.from({ length: DIRECTIONS }, (_, i) => {
      const angle = (2 * Math.PI * i) / DIRECTIONS
      return shareAt(distance * Math.cos(angle), distance * Math.sin(angle))
    }),
  )
  const chance = mean(shifted)
  return chance < 1 ? (shareAt(0, 0) - chance) / (1 - chance) : undefined
}

/** Finds out whether a point of a pattern is within `SAME` of a position. */
class Cover {
  /** Points by cell. Cells are squares with sides of `SAME`. */
  readonly #cells = new Map<number, FlatPoint[]>()

  constructor(points: readonly FlatPoint[]) {
    for (const point of points) {
      const key = keyOf(cellOf(point[0]), cellOf(point[1]))
      const cell = this.#cells.get(key)
      if (cell) cell.push(point)
      else this.#cells.set(key, [point])
    }
  }

  has(x: number, y: number): boolean {
    const [column, row] = [cellOf(x), cellOf(y)]
    for (let i = column - 1; i <= column + 1; i++) {
      for (let j = row - 1; j <= row + 1; j++) {
        for (const [px, py] of this.#cells.get(keyOf(i, j)) ?? NO_POINTS)
          if ((px - x) ** 2 + (py - y) ** 2 < SAME ** 2) return true
      }
    }
    return false
  }
}

const NO_POINTS: readonly FlatPoint[] = []

function cellOf(value: number): number {
  return Math.floor(value / SAME)
}

/** Returns the number of a cell. Each cell of a chart has its own number if the chart is smaller than 40 m. */
function keyOf(column: number, row: number): number {
  return 2 ** 16 * column + row
}
