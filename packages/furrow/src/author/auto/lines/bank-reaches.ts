import { PointGrid } from '../../../math/point-grid.ts'
import { cross, dot, length } from '../../../math/vector.ts'
import type { SkinLine } from '../../strokes/curve.ts'

/** A line is sampled at every fifth point. */
const SAMPLE_STEP = 5
/** Minimum distance to a neighbouring line, as a multiple of `spacing`. Lines that are nearer are pieces of the same wrinkle. */
const MIN_DISTANCE = 0.35
/** Maximum distance to a neighbouring line, as a multiple of `spacing`. The banks of lines farther apart do not meet. */
const MAX_DISTANCE = 1.6
/** A bank ends at a neighbouring line only if the neighbour is beside at least this fraction of the line. */
const MIN_COVERAGE = 0.4
/** Reach of a bank without a neighbouring line, as a multiple of `spacing`. */
const DEFAULT_REACH = 0.8
/** Minimum depth of a neighbouring line, as a fraction of the line's depth. A shallower line does not end the bank that it crosses. */
const MIN_DEPTH = 0.5

/**
 * Computes the reach of the banks on the left and right of each line, in millimetres. A bank is the raised skin beside a line. It
 * reaches to the neighbouring line, so that the banks of both lines form one bulge.
 *
 * @param depths relative depths of the lines.
 * @param spacing approximate distance between lines in millimetres.
 */
export function bankReaches(
  lines: readonly SkinLine[],
  depths: readonly number[],
  spacing: number,
): [left: number, right: number][] {
  const neighbours = new LinePoints(lines, MAX_DISTANCE * spacing)
  return lines.map((line, index) => {
    const isDeep = (other: number) => other !== index && depths[other] >= MIN_DEPTH * depths[index]
    const distances: [number[], number[]] = [[], []]
    let samples = 0
    for (let i = 0; i + 5 < line.points.length; i += 3 * SAMPLE_STEP) {
      samples++
      const nearest = nearestBeside(
        line,
        i,
        neighbours.nearest(line.points.subarray(i, i + 3), isDeep),
        spacing,
      )
      for (const [side, distance] of nearest.entries()) {
        if (distance <= MAX_DISTANCE * spacing) distances[side].push(distance)
      }
    }
    const reachOf = (found: number[]) =>
      found.length > MIN_COVERAGE * samples ? median(found) : DEFAULT_REACH * spacing
    return [reachOf(distances[0]), reachOf(distances[1])]
  })
}

/** Points of lines in a grid, to find the lines near a position. */
class LinePoints {
  readonly #lines: readonly SkinLine[]
  readonly #grid: PointGrid
  /** Line of each point in the grid. */
  readonly #lineOf: number[] = []
  /** Index of each point's coordinates in its line. */
  readonly #offsetOf: number[] = []

  /** @param reach search radius. */
  constructor(lines: readonly SkinLine[], reach: number) {
    this.#lines = lines
    this.#grid = new PointGrid(reach)
    for (const [line, { points }] of lines.entries()) {
      this.#grid.add(points)
      for (let i = 0; i < points.length; i += 3) {
        this.#lineOf.push(line)
        this.#offsetOf.push(i)
      }
    }
  }

  /**
   * Returns the nearest point of each line that comes within reach, and also of some lines slightly farther away. Skips lines for which
   * `isSearched` is false.
   */
  nearest(position: Float64Array, isSearched: (line: number) => boolean): Float64Array[] {
    const found = new Map<number, { point: number; square: number }>()
    this.#grid.visitNear(position, (point, square) => {
      const line = this.#lineOf[point]
      const before = found.get(line)
      if (!before) {
        if (isSearched(line)) found.set(line, { point, square })
        return
      }
      // On a tie, the first point wins.
      if (square > before.square || (square === before.square && point > before.point)) return
      before.point = point
      before.square = square
    })
    return [...found].map(([line, { point }]) => {
      const offset = this.#offsetOf[point]
      return this.#lines[line].points.subarray(offset, offset + 3)
    })
  }
}

/** Returns two distances from a point of a line: to the nearest of `others` on the left of the line, and to the nearest on the right. */
function nearestBeside(
  { points, normals }: SkinLine,
  i: number,
  others: readonly Float64Array[],
  spacing: number,
): [left: number, right: number] {
  const along = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k])
  const right = new Float64Array(3)
  cross(right, along, normals.subarray(i, i + 3))
  const nearest: [number, number] = [Infinity, Infinity]
  for (const other of others) {
    const offset = [0, 1, 2].map((k) => other[k] - points[i + k])
    const distance = length(offset)
    if (distance < MIN_DISTANCE * spacing) continue
    // Skip points that are ahead of the line or behind it rather than beside it.
    const across = dot(offset, right) / (length(right) * distance)
    if (Math.abs(across) < Math.SQRT1_2) continue
    const side = across < 0 ? 0 : 1
    nearest[side] = Math.min(nearest[side], distance)
  }
  return nearest
}

function median(values: number[]): number {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
}
