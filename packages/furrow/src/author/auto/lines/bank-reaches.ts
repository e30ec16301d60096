import { cross, dot, length } from '../../../math/vector.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import { PointGrid } from './point-grid.ts'

/** Points of a line from one sample to the next. */
const EVERY = 5
/** Distances to a neighbouring line in spacings: nearer ones are pieces of the same line, those farther away have skin of their own. */
const NEAREST = 0.35
const FARTHEST = 1.6
/** Fraction of a line along which it must have a neighbour for its bank to reach there. */
const ALONG = 0.4
/** How far a bank reaches where there is none, in spacings. */
const ALONE = 0.8
/** Neighbours less deep than this, as a fraction of the line's depth, lie on its bank and do not end it. */
const SHALLOW = 0.5

/**
 * How far the banks of lines reach, left and right of each in millimetres: to the neighbouring line, so that both have one bulge of skin in
 * common.
 *
 * @param depths of the lines, to compare them by.
 * @param spacing from line to line, about.
 */
export function bankReaches(
  lines: readonly SkinLine[],
  depths: readonly number[],
  spacing: number,
): [left: number, right: number][] {
  const neighbours = new LinePoints(lines, FARTHEST * spacing)
  return lines.map((line, index) => {
    const isDeep = (other: number) => other !== index && depths[other] >= SHALLOW * depths[index]
    const distances: [number[], number[]] = [[], []]
    let samples = 0
    for (let i = 0; i + 5 < line.points.length; i += 3 * EVERY) {
      samples++
      const nearest = nearestBeside(
        line,
        i,
        neighbours.nearest(line.points.subarray(i, i + 3), isDeep),
        spacing,
      )
      for (const [side, distance] of nearest.entries()) {
        if (distance <= FARTHEST * spacing) distances[side].push(distance)
      }
    }
    const reachOf = (found: number[]) => (found.length > ALONG * samples ? median(found) : ALONE * spacing)
    return [reachOf(distances[0]), reachOf(distances[1])]
  })
}

/** The points of lines, searched by position: the cost does not grow with lines that are far away. */
class LinePoints {
  readonly #lines: readonly SkinLine[]
  readonly #grid: PointGrid
  /** Line and offset of the coordinates of each point of the grid. */
  readonly #lineOf: number[] = []
  readonly #offsetOf: number[] = []

  /** @param reach distance up to which points are found. */
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

  /** Coordinates of the nearest point of each line that is within reach, and of some that are farther away. */
  nearest(position: Float64Array, isSearched: (line: number) => boolean): Float64Array[] {
    const found = new Map<number, { point: number; square: number }>()
    this.#grid.visitNear(position, (point, square) => {
      const line = this.#lineOf[point]
      const before = found.get(line)
      if (!before) {
        if (isSearched(line)) found.set(line, { point, square })
        return
      }
      // The first of points at the same distance.
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

/** From a point of a line to the nearest of other lines' points on its left and on its right. */
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
    if (distance < NEAREST * spacing) continue
    // Beside the line, and not ahead of it.
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
