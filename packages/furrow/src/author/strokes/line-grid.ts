import type { SkinLine } from './curve.ts'
import { LineSegments } from './line-segments.ts'

/**
 * Minimum side of a cell in millimetres, and maximum number of cells along the longest side. The limit keeps cell indices exact on skin
 * of any size.
 */
const MIN_CELL = 4
const MAX_CELLS_PER_AXIS = 2 ** 16
/** Ratio of cube sides between two levels; the lowest level consists of the cells. */
const BRANCHING = 4
/** Maximum count of numbers stored per level. A full level is emptied, which bounds the memory on dense lines. */
const MAX_CACHED = 2 ** 21
/** Distance from the centre of a cube to its corners in half sides, with a margin for rounding. */
const RADIUS = 1.0005 * Math.sqrt(3)
/** Maximum number of cells searched for a box; larger boxes count as near. */
const MAX_CELLS = 4096
/** Marks a missing segment index. */
const NONE = -1
const NO_RUNS = new Int32Array(0)
/**
 * Receives the nearest point of a line.
 *
 * @param line index of the line.
 * @param distance in millimetres.
 * @param segment index of the point before the nearest point.
 * @param t position along the segment, 0..1.
 * @param side -1 left of the line as seen from outside, 1 right, 0 on the line; in between around its ends.
 */
export type LineVisitor = (line: number, distance: number, segment: number, t: number, side: number) => void

/** Cubes of one size. Each holds the segments within reach as runs, computed on first access. */
interface Level {
  /** Side of a cube in millimetres. */
  side: number
  /** Index of the first cube along each axis, and number of cubes along y and z. */
  low: readonly number[]
  rows: number
  layers: number
  cubes: Map<number, Int32Array>
}

/**
 * Finds lines near positions on the skin with a hierarchical grid. Cells are filled on first access, because few cells of a skin are within
 * reach of a line. Each level filters the runs of the next larger cubes. Results at a position depend only on the lines within reach.
 */
export class LineGrid {
  readonly #reaches: readonly number[]
  /** Side of a cell in millimetres. */
  readonly #cell: number
  readonly #segments: LineSegments
  /** Segment found by the last visit, per line: the next texel mostly finds the same one. */
  readonly #last: Int32Array
  /** Levels from the cells up. */
  readonly #levels: readonly Level[]
  /** Count of numbers stored per level. */
  readonly #held: number[]
  /** Cell of the last access: mostly also the cell of the next texel. */
  #around: { i: number; j: number; k: number; cell: Int32Array } = { i: NaN, j: NaN, k: NaN, cell: NO_RUNS }
  /** First and last cell within reach of any line, along each axis. */
  readonly #low = [Infinity, Infinity, Infinity]
  readonly #high = [-Infinity, -Infinity, -Infinity]

  /** @param reaches search radius of each line in millimetres. */
  constructor(lines: readonly SkinLine[], reaches: readonly number[]) {
    this.#reaches = reaches
    this.#cell = Math.max(MIN_CELL, extentOf(lines) / MAX_CELLS_PER_AXIS)
    this.#segments = new LineSegments(lines)
    this.#last = new Int32Array(lines.length).fill(NONE)
    for (const [line, { points }] of lines.entries()) this.#widen(points, reaches[line])
    this.#levels = this.#levelsOf()
    this.#held = this.#levels.map(() => 0)
  }

  /** Returns whether lines may be within reach of a box, given by its lowest and highest x, y and z. */
  readonly isNear = (low: ArrayLike<number>, high: ArrayLike<number>): boolean => {
    const left = Math.max(this.#cellOf(low[0]), this.#low[0])
    const right = Math.min(this.#cellOf(high[0]), this.#high[0])
    const bottom = Math.max(this.#cellOf(low[1]), this.#low[1])
    const top = Math.min(this.#cellOf(high[1]), this.#high[1])
    const back = Math.max(this.#cellOf(low[2]), this.#low[2])
    const front = Math.min(this.#cellOf(high[2]), this.#high[2])
    if (left > right || bottom > top || back > front) return false
    if ((right - left + 1) * (top - bottom + 1) * (front - back + 1) > MAX_CELLS) return true
    for (let x = left; x <= right; x++) {
      for (let y = bottom; y <= top; y++) {
        for (let z = back; z <= front; z++) if (this.#cubeAt(0, x, y, z).length > 0) return true
      }
    }
    return false
  }

  /** Returns whether lines are within reach of a position, whichever way they face. */
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
   * Visits each line within reach once, in order, at the nearest point whose normal agrees with the skin's.
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
      /** Search radius: farther segments are out of reach, or another one is nearer. */
      const most = Math.min(this.#reaches[line], Math.sqrt(least))
      const far = segments.farFrom(line, most)
      for (; run < cell.length && segments.lineOf[cell[run]] === line; run += 2) {
        const end = cell[run + 1]
        for (let segment = cell[run]; segment < end; ) {
          const square = segments.squareTo(segment, x, y, z)
          // On a tie, the lowest index wins, independent of the cached segment.
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

  /** Widens the box within reach of any line by the points of one line. A single point has no segment. */
  #widen(points: Float64Array, reach: number): void {
    if (points.length < 6) return
    for (let i = 0; i < points.length; i++) {
      this.#low[i % 3] = Math.min(this.#low[i % 3], this.#cellOf(points[i] - reach))
      this.#high[i % 3] = Math.max(this.#high[i % 3], this.#cellOf(points[i] + reach))
    }
  }

  /** Returns the runs of the cell that contains a position. */
  #cellAround(x: number, y: number, z: number): Int32Array {
    const [i, j, k] = [this.#cellOf(x), this.#cellOf(y), this.#cellOf(z)]
    const around = this.#around
    if (around.i === i && around.j === j && around.k === k) return around.cell
    const [low, high] = [this.#low, this.#high]
    const isInside = i >= low[0] && i <= high[0] && j >= low[1] && j <= high[1] && k >= low[2] && k <= high[2]
    // NaN positions are outside.
    const cell = isInside ? this.#cubeAt(0, i, j, k) : NO_RUNS
    this.#around = { i, j, k, cell }
    return cell
  }

  /** Returns the runs of a cube, given by its index along each axis. */
  #cubeAt(level: number, x: number, y: number, z: number): Int32Array {
    if (level === this.#levels.length) return this.#segments.runs
    const { side, low, rows, layers, cubes } = this.#levels[level]
    const key = ((x - low[0]) * rows + (y - low[1])) * layers + (z - low[2])
    const known = cubes.get(key)
    if (known) return known
    const [i, j, k] = [Math.floor(x / BRANCHING), Math.floor(y / BRANCHING), Math.floor(z / BRANCHING)]
    const cube = this.#within(this.#cubeAt(level + 1, i, j, k), x, y, z, side)
    if (this.#held[level] > MAX_CACHED) {
      cubes.clear()
      this.#held[level] = 0
    }
    this.#held[level] += cube.length
    cubes.set(key, cube)
    return cube
  }

  /** Creates levels until a cube is nearly as large as the box within reach of any line. */
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

  /** Filters runs to the segments within reach of a cube, given by its index along each axis and its side. */
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

/** Returns the longest side of the bounding box of the lines. */
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
