import type { SkinLine } from './curve.ts'

/** Side of a cell in millimetres, and cells along the longest side of the grid, at most: their indices stay exact on skin of any size. */
const MIN_CELL = 4
const MOST_IN_ROW = 2 ** 16
/** How many times as long the side of a cube is as that of the cubes one level below, of which the lowest are the cells. */
const BRANCHING = 4
/** From the centre of a cube to its corners, in halves of its side, with a margin for rounding. */
const RADIUS = 1.0005 * Math.sqrt(3)
/** Cells of the largest box that is searched; a larger one counts as near. */
const MOST_CELLS = 4096
/** Cosine between normals below which two points face different directions: one lip is not the other. */
const FACING = 0.25
/** Numbers per segment: start, vector to its end, one over its squared length, normal. */
const STRIDE = 10

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

/** Cubes of one size: the segments within reach of each, filled when they are first asked for. */
interface Level {
  /** Of a cube, in millimetres. */
  side: number
  /** Index of the first cube along each axis, and cubes along y and z. */
  low: readonly number[]
  rows: number
  layers: number
  cubes: Map<number, readonly number[]>
}

/**
 * Finds lines near positions on the skin, by a grid of cells that are filled when they are first asked for, since skin has few of those
 * that are within reach of a line: each from the cube of cells that it is in, that one from a larger one, the largest from all segments.
 */
export class LineGrid {
  readonly #reaches: readonly number[]
  /** Side of a cell in millimetres. */
  readonly #cell: number
  readonly #segments: Float64Array
  /** Of each segment its line, and the point it starts from. */
  readonly #lineOf: Int32Array
  readonly #pointOf: Int32Array
  /** From the cells up. */
  readonly #levels: readonly Level[]
  /** All segments. */
  readonly #all: readonly number[]
  /** The first and last cell within reach of any line, along each axis. */
  readonly #low = [Infinity, Infinity, Infinity]
  readonly #high = [-Infinity, -Infinity, -Infinity]
  /** Of each line that a visit comes across: squared distance (-1 for none), nearest segment, position along it. */
  readonly #squares: Float64Array
  readonly #nearest: Int32Array
  readonly #t: Float64Array
  /** The lines that a visit comes across. */
  readonly #found: Int32Array

  /** @param reaches how far away each line is found, in millimetres. */
  constructor(lines: readonly SkinLine[], reaches: readonly number[]) {
    this.#reaches = reaches
    this.#cell = Math.max(MIN_CELL, extentOf(lines) / MOST_IN_ROW)
    const total = lines.reduce((sum, { points }) => sum + Math.max(0, points.length / 3 - 1), 0)
    this.#segments = new Float64Array(STRIDE * total)
    this.#lineOf = new Int32Array(total)
    this.#pointOf = new Int32Array(total)
    this.#squares = new Float64Array(lines.length).fill(-1)
    this.#nearest = new Int32Array(lines.length)
    this.#t = new Float64Array(lines.length)
    this.#found = new Int32Array(lines.length)
    let segment = 0
    for (const [line, { points, normals }] of lines.entries()) {
      for (let point = 0; point + 1 < points.length / 3; point++) {
        this.#lineOf[segment] = line
        this.#pointOf[segment] = point
        this.#store(segment, points, normals)
        this.#widen(segment++)
      }
    }
    this.#all = Array.from({ length: total }, (_, i) => i)
    this.#levels = this.#levelsOf()
  }

  /** Whether lines may be within reach of a box. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    const [left, right] = [
      Math.max(this.#cellOf(low[0]), this.#low[0]),
      Math.min(this.#cellOf(high[0]), this.#high[0]),
    ]
    const [bottom, top] = [
      Math.max(this.#cellOf(low[1]), this.#low[1]),
      Math.min(this.#cellOf(high[1]), this.#high[1]),
    ]
    const [back, front] = [
      Math.max(this.#cellOf(low[2]), this.#low[2]),
      Math.min(this.#cellOf(high[2]), this.#high[2]),
    ]
    if (left > right || bottom > top || back > front) return false
    if ((right - left + 1) * (top - bottom + 1) * (front - back + 1) > MOST_CELLS) return true
    for (let x = left; x <= right; x++) {
      for (let y = bottom; y <= top; y++) {
        for (let z = back; z <= front; z++) if (this.#cellAt(x, y, z).length > 0) return true
      }
    }
    return false
  }

  /**
   * Visits each line within reach once, at its nearest point.
   *
   * @param x, y, z a position on the skin.
   * @param nx, ny, nz the skin's normal there.
   */
  visit(x: number, y: number, z: number, nx: number, ny: number, nz: number, visit: LineVisitor): void {
    const cell = this.#cellAt(this.#cellOf(x), this.#cellOf(y), this.#cellOf(z))
    const s = this.#segments
    let found = 0
    for (let i = 0; i < cell.length; i++) {
      const segment = cell[i]
      const k = STRIDE * segment
      if (s[k + 7] * nx + s[k + 8] * ny + s[k + 9] * nz < FACING) continue
      const vx = x - s[k]
      const vy = y - s[k + 1]
      const vz = z - s[k + 2]
      const along = (s[k + 3] * vx + s[k + 4] * vy + s[k + 5] * vz) * s[k + 6]
      const t = along < 0 ? 0 : along > 1 ? 1 : along
      const dx = vx - t * s[k + 3]
      const dy = vy - t * s[k + 4]
      const dz = vz - t * s[k + 5]
      const square = dx * dx + dy * dy + dz * dz
      const line = this.#lineOf[segment]
      if (this.#squares[line] < 0) this.#found[found++] = line
      else if (square >= this.#squares[line]) continue
      this.#squares[line] = square
      this.#nearest[line] = segment
      this.#t[line] = t
    }
    for (let i = 0; i < found; i++) {
      const line = this.#found[i]
      const distance = Math.sqrt(this.#squares[line])
      this.#squares[line] = -1
      if (distance >= this.#reaches[line]) continue
      const segment = this.#nearest[line]
      const side = this.#sideOf(segment, x, y, z, this.#t[line])
      visit(line, distance, this.#pointOf[segment], this.#t[line], side)
    }
  }

  /**
   * The sine of the angle, in the skin, between the segment and what lies to the right of it: 1 beside the line, less round its ends. The
   * distance above the tangent plane does not count, for skin is curved.
   */
  #sideOf(segment: number, x: number, y: number, z: number, t: number): number {
    const s = this.#segments
    const k = STRIDE * segment
    const vx = x - s[k]
    const vy = y - s[k + 1]
    const vz = z - s[k + 2]
    // Both times the segment's length; (segment x offset) . normal is on the left.
    const left =
      s[k + 7] * (s[k + 4] * vz - s[k + 5] * vy) +
      s[k + 8] * (s[k + 5] * vx - s[k + 3] * vz) +
      s[k + 9] * (s[k + 3] * vy - s[k + 4] * vx)
    const isEnd =
      t > 0 ? t === 1 && this.#lineOf[segment + 1] !== this.#lineOf[segment] : this.#pointOf[segment] === 0
    const beyond = isEnd ? s[k + 3] * vx + s[k + 4] * vy + s[k + 5] * vz - (t > 0 ? 1 / s[k + 6] : 0) : 0
    return left === 0 ? 0 : -left / Math.hypot(left, beyond)
  }

  #store(segment: number, points: Float64Array, normals: Float64Array): void {
    const start = 3 * this.#pointOf[segment]
    let square = 0
    for (let k = 0; k < 3; k++) {
      const component = points[start + 3 + k] - points[start + k]
      this.#segments[STRIDE * segment + k] = points[start + k]
      this.#segments[STRIDE * segment + 3 + k] = component
      this.#segments[STRIDE * segment + 7 + k] = normals[start + k]
      square += component * component
    }
    this.#segments[STRIDE * segment + 6] = square > 0 ? 1 / square : 0
  }

  /** Widens the box within reach of any line by a segment. */
  #widen(segment: number): void {
    const reach = this.#reaches[this.#lineOf[segment]]
    for (let k = 0; k < 3; k++) {
      const start = this.#segments[STRIDE * segment + k]
      const end = start + this.#segments[STRIDE * segment + 3 + k]
      this.#low[k] = Math.min(this.#low[k], this.#cellOf(Math.min(start, end) - reach))
      this.#high[k] = Math.max(this.#high[k], this.#cellOf(Math.max(start, end) + reach))
    }
  }

  /** The segments whose lines may be within reach of a cell. */
  #cellAt(x: number, y: number, z: number): readonly number[] {
    const [low, high] = [this.#low, this.#high]
    // Not the other way round: NaN is nowhere.
    if (!(x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] && z <= high[2]))
      return NONE
    return this.#cubeAt(0, x, y, z)
  }

  /** The segments whose lines may be within reach of a cube, given by its index along each axis. */
  #cubeAt(level: number, x: number, y: number, z: number): readonly number[] {
    if (level === this.#levels.length) return this.#all
    const { side, low, rows, layers, cubes } = this.#levels[level]
    const key = ((x - low[0]) * rows + (y - low[1])) * layers + (z - low[2])
    let cube = cubes.get(key)
    if (!cube) {
      const [i, j, k] = [Math.floor(x / BRANCHING), Math.floor(y / BRANCHING), Math.floor(z / BRANCHING)]
      const larger = this.#cubeAt(level + 1, i, j, k)
      cube = larger.length > 0 ? this.#within(larger, x, y, z, side) : NONE
      cubes.set(key, cube)
    }
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

  /** Those of some segments whose lines may be within reach of a cube, given by its index along each axis and its side. */
  #within(segments: readonly number[], x: number, y: number, z: number, side: number): readonly number[] {
    const radius = (side / 2) * RADIUS
    const [px, py, pz] = [(x + 0.5) * side, (y + 0.5) * side, (z + 0.5) * side]
    return segments.filter(
      (segment) =>
        this.#squareTo(segment, px, py, pz) <= (this.#reaches[this.#lineOf[segment]] + radius) ** 2,
    )
  }

  /** The squared distance from a position to a segment. */
  #squareTo(segment: number, px: number, py: number, pz: number): number {
    const s = this.#segments
    const k = STRIDE * segment
    const x = px - s[k]
    const y = py - s[k + 1]
    const z = pz - s[k + 2]
    const along = (s[k + 3] * x + s[k + 4] * y + s[k + 5] * z) * s[k + 6]
    const t = along < 0 ? 0 : along > 1 ? 1 : along
    return (x - t * s[k + 3]) ** 2 + (y - t * s[k + 4]) ** 2 + (z - t * s[k + 5]) ** 2
  }

  #cellOf(millimetres: number): number {
    return Math.floor(millimetres / this.#cell)
  }
}

const NONE: readonly number[] = []

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
