import { cross, dot, length } from '../../../math/vector.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import { PointGrid } from './point-grid.ts'

/** Step between samples of a line, in points. */
const SAMPLE_STEP = 5
/** Range of distances to a neighbouring line, in spacings. Nearer points are pieces of the same line; farther lines share no skin. */
const MIN_DISTANCE = 0.35
const MAX_DISTANCE = 1.6
/** Minimum fraction of a line along which it must have a neighbour for its bank to end there. */
const MIN_COVERAGE = 0.4
/** Reach of a bank without a neighbour, in spacings. */
const DEFAULT_REACH = 0.8
/** Neighbours shallower than this fraction of the line's depth lie on its bank and do not end it. */
const MIN_DEPTH = 0.5

/**
 * Computes the reach of banks, left and right of each line in millimetres: up to the neighbouring line, so that both share one bulge of
 * skin.
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

/** Points of lines, indexed by position: distant lines cost nothing. */
class LinePoints {
  readonly #lines: readonly SkinLine[]
  readonly #grid: PointGrid
  /** Line of each grid point, and offset of its coordinates. */
  readonly #lineOf: number[] = []
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

  /** Returns the nearest point of each line within reach; may include more distant lines. */
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

/** Returns the distances from a point of a line to the nearest of the other points on its left and right. */
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
    // Only points beside the line, not ahead of it.
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
