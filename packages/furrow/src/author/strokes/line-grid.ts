import type { SkinLine } from './curve.ts'
import { LineSegments } from './line-segments.ts'

/** Minimum edge length of a cell in millimetres. A cell is a cube of the grid's finest level. */
const MIN_CELL = 4
/** Maximum number of cells along the longest axis. On very large skin, cells are larger, so that the keys of `Level.cubes` stay below 2^53. */
const MAX_CELLS_PER_AXIS = 2 ** 16
/** Ratio between the edge lengths of cubes in two successive levels. */
const BRANCHING = 4
/** Maximum number of segment indices cached per level. A level that exceeds this number is emptied, to bound the memory. */
const MAX_CACHED = 2 ** 21
/** Distance from a cube's centre to its corners, as a multiple of half the edge length, with a margin for rounding. */
const RADIUS = 1.0005 * Math.sqrt(3)
/** Maximum number of cells that `isNear` searches. For boxes with more cells, `isNear` returns true. */
const MAX_CELLS = 4096
const NONE = -1
const NO_RUNS = new Int32Array(0)
/**
 * Receives the point of a line that is nearest to a position.
 *
 * @param line index of the line.
 * @param distance distance from the position to the nearest point, in millimetres.
 * @param segment index of the segment with the nearest point. Segment i joins the points i and i + 1 of the line.
 * @param t position of the nearest point along the segment, 0..1.
 * @param side -1 if the position is left of the line as seen from outside, 1 if it is right, 0 on the line. Around the ends of the line, the
 *   value changes continuously between -1 and 1.
 */
export type LineVisitor = (line: number, distance: number, segment: number, t: number, side: number) => void

/** Cubes of one size. */
interface Level {
  /** Edge length of a cube in millimetres. */
  side: number
  /** Index of the first cube along each axis. */
  low: readonly number[]
  /** Number of cubes along y. */
  rows: number
  /** Number of cubes along z. */
  layers: number
  /** Runs of the segments within reach of each cube (see `LineSegments.runs`), computed on first access. */
  cubes: Map<number, Int32Array>
}

/**
 * Uses a hierarchical grid of cubes to find the lines near a position on the skin. Each cube caches the line segments within reach. The first
 * query in a cube selects them from the segments of the next larger cube. Results at a position depend only on the lines within reach.
 */
export class LineGrid {
  readonly #reaches: readonly number[]
  /** Edge length of a cell in millimetres. */
  readonly #cell: number
  readonly #segments: LineSegments
  /** For each line, the segment nearest to the previously visited position. It is mostly nearest to the next position too. */
  readonly #last: Int32Array
  /** Levels of the grid, smallest cubes first. */
  readonly #levels: readonly Level[]
  /** Number of segment indices cached per level. */
  readonly #held: number[]
  /** Cell of the previous position, cached because the next position is mostly in the same cell. */
  #around: { i: number; j: number; k: number; cell: Int32Array } = { i: NaN, j: NaN, k: NaN, cell: NO_RUNS }
  /** Indices of the first and the last cell within reach of any line, along x, y and z. */
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

  /** Returns whether a line may be within reach of a box, given by its lowest and highest x, y and z in millimetres. */
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

  /** Returns whether a line is within reach of a position. Unlike `visit`, ignores normals. */
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
   * Visits each line within reach of a position once, by ascending index. Ignores segments that `LineSegments.faces` rejects.
   *
   * @param position position on the skin in millimetres.
   * @param normal unit normal of the skin at the position.
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
      /** Search radius: segments farther away are beyond the line's reach, or farther than `last`. */
      const most = Math.min(this.#reaches[line], Math.sqrt(least))
      const far = segments.farFrom(line, most)
      for (; run < cell.length && segments.lineOf[cell[run]] === line; run += 2) {
        const end = cell[run + 1]
        for (let segment = cell[run]; segment < end; ) {
          const square = segments.squareTo(segment, x, y, z)
          // On a tie, the lowest index wins, so that the result does not depend on the cached segment.
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

  /** Extends `#low` and `#high` to the cells within reach of a line. A line with a single point has no segment and is skipped. */
  #widen(points: Float64Array, reach: number): void {
    if (points.length < 6) return
    for (let i = 0; i < points.length; i++) {
      this.#low[i % 3] = Math.min(this.#low[i % 3], this.#cellOf(points[i] - reach))
      this.#high[i % 3] = Math.max(this.#high[i % 3], this.#cellOf(points[i] + reach))
    }
  }

  /** Returns the segments within reach of the cell that contains a position, in the format of `LineSegments.runs`. */
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

  /** Returns the segments within reach of a cube, in the format of `LineSegments.runs`. The cube is given by its index along each axis. */
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

  /** Creates levels of growing cubes, until the next cube would be as large as the region within reach of all lines. */
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

  /** Returns the segments of `runs` within reach of the cube with the indices `x`, `y`, `z` and the edge length `side`. */
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

/** Returns the longest edge of the lines' bounding box in millimetres. */
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
