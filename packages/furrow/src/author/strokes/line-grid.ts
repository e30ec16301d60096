import type { SkinLine } from './curve.ts'
import { LineSegments } from './line-segments.ts'

/** Side of a cell in millimetres, and cells along the longest side of the grid, at most: their indices stay exact on skin of any size. */
const MIN_CELL = 4
const MOST_IN_ROW = 2 ** 16
/** How many times as long the side of a cube is as that of the cubes one level below, of which the lowest are the cells. */
const BRANCHING = 4
/** Numbers that the cubes of a level hold together; when there are more, the level is emptied: bounds the memory on dense lines. */
const MOST_HELD = 2 ** 21
/** From the centre of a cube to its corners, in halves of its side, with a margin for rounding. */
const RADIUS = 1.0005 * Math.sqrt(3)
/** Cells of the largest box that is searched; a larger one counts as near. */
const MOST_CELLS = 4096
/** Index of no segment. */
const NONE = -1
const NO_RUNS = new Int32Array(0)
/**
 * Is given the point of a line that is nearest.
 *
 * @param line its index.
 * @param distance in millimetres.
 * @param segment index of the point before it.
 * @param t how far it is along the segment, 0..1.
 * @param side -1 where the position is on the left of the line as seen from outside, 1 on its right, in between round its ends; 0 on it.
 */
export type LineVisitor = (line: number, distance: number, segment: number, t: number, side: number) => void

/** Cubes of one size: the segments within reach of each as runs, filled when they are first asked for. */
interface Level {
  /** Of a cube, in millimetres. */
  side: number
  /** Index of the first cube along each axis, and cubes along y and z. */
  low: readonly number[]
  rows: number
  layers: number
  cubes: Map<number, Int32Array>
}

/**
 * Finds lines near positions on the skin, by a grid of cells that are filled when they are first asked for, since skin has few of those
 * that are within reach of a line: each from the cube of cells that it is in, that one from a larger one, the largest from all segments.
 * What is found at a position depends on the lines within reach of it alone.
 */
export class LineGrid {
  readonly #reaches: readonly number[]
  /** Side of a cell in millimetres. */
  readonly #cell: number
  readonly #segments: LineSegments
  /** The segment of each line that a visit found last: from one texel to the next it changes little. */
  readonly #last: Int32Array
  /** From the cells up. */
  readonly #levels: readonly Level[]
  /** How many numbers the cubes of each level hold together. */
  readonly #held: number[]
  /** The cell that was asked for last: that of the next texel too, mostly. */
  #around: { i: number; j: number; k: number; cell: Int32Array } = { i: NaN, j: NaN, k: NaN, cell: NO_RUNS }
  /** The first and last cell within reach of any line, along each axis. */
  readonly #low = [Infinity, Infinity, Infinity]
  readonly #high = [-Infinity, -Infinity, -Infinity]

  /** @param reaches how far away each line is found, in millimetres. */
  constructor(lines: readonly SkinLine[], reaches: readonly number[]) {
    this.#reaches = reaches
    this.#cell = Math.max(MIN_CELL, extentOf(lines) / MOST_IN_ROW)
    this.#segments = new LineSegments(lines)
    this.#last = new Int32Array(lines.length).fill(NONE)
    for (const [line, { points }] of lines.entries()) this.#widen(points, reaches[line])
    this.#levels = this.#levelsOf()
    this.#held = this.#levels.map(() => 0)
  }

  /** Whether lines may be within reach of a box, given by its lowest and highest x, y and z. */
  readonly isNear = (low: ArrayLike<number>, high: ArrayLike<number>): boolean => {
    const left = Math.max(this.#cellOf(low[0]), this.#low[0])
    const right = Math.min(this.#cellOf(high[0]), this.#high[0])
    const bottom = Math.max(this.#cellOf(low[1]), this.#low[1])
    const top = Math.min(this.#cellOf(high[1]), this.#high[1])
    const back = Math.max(this.#cellOf(low[2]), this.#low[2])
    const front = Math.min(this.#cellOf(high[2]), this.#high[2])
    if (left > right || bottom > top || back > front) return false
    if ((right - left + 1) * (top - bottom + 1) * (front - back + 1) > MOST_CELLS) return true
    for (let x = left; x <= right; x++) {
      for (let y = bottom; y <= top; y++) {
        for (let z = back; z <= front; z++) if (this.#cubeAt(0, x, y, z).length > 0) return true
      }
    }
    return false
  }

  /** Whether lines are within reach of a position, whichever way they face. */
  isWithinReach(position: ArrayLike<number>): boolean {
    const [x, y, z] = [position[0], position[1], position[2]]
    const cell = this.#cellAround(x, y, z)
    for (let run = 0; run < cell.length; run += 2) {
      const line = this.#segments.lineOf[cell[run]]
      for (let segment = cell[run]; segment < cell[run + 1]; ) {
        const square = this.#segments.squareTo(segment, x, y, z)
        if (square < this.#reaches[line] ** 2) return true
        segment += this.#segments.stepsTo(line, square, this.#reaches[line])
      }
    }
    return false
  }

  /**
   * Visits each line within reach once, at its nearest point that faces as the skin does, in the order of the lines.
   *
   * @param position on the skin.
   * @param normal of the skin there.
   */
  visit(position: ArrayLike<number>, normal: ArrayLike<number>, visit: LineVisitor): void {
    const [x, y, z] = [position[0], position[1], position[2]]
    const [nx, ny, nz] = [normal[0], normal[1], normal[2]]
    const cell = this.#cellAround(x, y, z)
    const segments = this.#segments
    for (let run = 0; run < cell.length; ) {
      const line = segments.lineOf[cell[run]]
      let nearest = NONE
      let least = Infinity
      const last = this.#last[line]
      if (last !== NONE && segments.faces(last, nx, ny, nz)) {
        nearest = last
        least = segments.squareTo(last, x, y, z)
      }
      /** What is farther need not be looked at: another segment is nearer, or the line is out of reach. */
      const most = Math.min(this.#reaches[line], Math.sqrt(least))
      const far = segments.farFrom(line, most)
      for (; run < cell.length && segments.lineOf[cell[run]] === line; run += 2) {
        const end = cell[run + 1]
        for (let segment = cell[run]; segment < end; ) {
          const square = segments.squareTo(segment, x, y, z)
          // The first of those that are as near, as without the one that was found last.
          const isNearer = square < least || (square === least && segment < nearest)
          if (isNearer && segments.faces(segment, nx, ny, nz)) {
            nearest = segment
            least = square
          }
          segment += square < far ? 1 : segments.stepsTo(line, square, most)
        }
      }
      const distance = Math.sqrt(least)
      if (distance >= this.#reaches[line]) continue
      this.#last[line] = nearest
      const t = segments.fractionAt(nearest, x, y, z)
      visit(line, distance, segments.pointOf[nearest], t, segments.sideOf(nearest, x, y, z, t))
    }
  }

  /** Widens the box within reach of any line by the points of one. A point alone has no segment. */
  #widen(points: Float64Array, reach: number): void {
    if (points.length < 6) return
    for (let i = 0; i < points.length; i++) {
      this.#low[i % 3] = Math.min(this.#low[i % 3], this.#cellOf(points[i] - reach))
      this.#high[i % 3] = Math.max(this.#high[i % 3], this.#cellOf(points[i] + reach))
    }
  }

  /** The runs of the cell that a position is in. */
  #cellAround(x: number, y: number, z: number): Int32Array {
    const [i, j, k] = [this.#cellOf(x), this.#cellOf(y), this.#cellOf(z)]
    const around = this.#around
    if (around.i === i && around.j === j && around.k === k) return around.cell
    const [low, high] = [this.#low, this.#high]
    const isInside = i >= low[0] && i <= high[0] && j >= low[1] && j <= high[1] && k >= low[2] && k <= high[2]
    // A position that is NaN is nowhere.
    const cell = isInside ? this.#cubeAt(0, i, j, k) : NO_RUNS
    this.#around = { i, j, k, cell }
    return cell
  }

  /** The runs of a cube, given by its index along each axis. */
  #cubeAt(level: number, x: number, y: number, z: number): Int32Array {
    if (level === this.#levels.length) return this.#segments.runs
    const { side, low, rows, layers, cubes } = this.#levels[level]
    const key = ((x - low[0]) * rows + (y - low[1])) * layers + (z - low[2])
    const known = cubes.get(key)
    if (known) return known
    const [i, j, k] = [Math.floor(x / BRANCHING), Math.floor(y / BRANCHING), Math.floor(z / BRANCHING)]
    const cube = this.#within(this.#cubeAt(level + 1, i, j, k), x, y, z, side)
    if (this.#held[level] > MOST_HELD) {
      cubes.clear()
      this.#held[level] = 0
    }
    this.#held[level] += cube.length
    cubes.set(key, cube)
    return cube
  }

  /** Up to the level whose cubes are nearly as large as all that is within reach of any line. */
  #levelsOf(): Level[] {
    const levels: Level[] = []
    const extent = Math.max(...this.#high.map((high, k) => high - this.#low[k]))
    let cells = 1
    do {
      const [low, high] = [this.#low, this.#high].map((box) => box.map((cell) => Math.floor(cell / cells)))
      const [, rows, layers] = high.map((last, k) => last - low[k] + 1)
      levels.push({ side: cells * this.#cell, low, rows, layers, cubes: new Map() })
      cells *= BRANCHING
    } while (cells < extent)
    return levels
  }

  /** What of some runs is within reach of a cube, given by its index along each axis and its side. */
  #within(runs: Int32Array, x: number, y: number, z: number, side: number): Int32Array {
    const radius = (side / 2) * RADIUS
    const [px, py, pz] = [(x + 0.5) * side, (y + 0.5) * side, (z + 0.5) * side]
    const segments = this.#segments
    const within: number[] = []
    for (let run = 0; run < runs.length; run += 2) {
      const line = segments.lineOf[runs[run]]
      const reach = this.#reaches[line] + radius
      for (let segment = runs[run]; segment < runs[run + 1]; ) {
        const square = segments.squareTo(segment, px, py, pz)
        if (square <= reach ** 2) {
          if (within.at(-1) === segment && segments.lineOf[segment - 1] === line) within.pop()
          else within.push(segment)
          within.push(segment + 1)
        }
        segment += segments.stepsTo(line, square, reach)
      }
    }
    return Int32Array.from(within)
  }

  #cellOf(millimetres: number): number {
    return Math.floor(millimetres / this.#cell)
  }
}

/** The longest side of the box round some lines. */
function extentOf(lines: readonly SkinLine[]): number {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ]
  for (const { points } of lines) {
    for (let i = 0; i < points.length; i++) {
      low[i % 3] = Math.min(low[i % 3], points[i])
      high[i % 3] = Math.max(high[i % 3], points[i])
    }
  }
  return Math.max(0, ...high.map((value, k) => value - low[k]))
}
