import { clamp } from '../../math/scalar.ts'
import type { SkinLine } from './curve.ts'

/** Side of the smallest cell in millimetres. */
const MIN_CELL = 4
/** Cells that the farthest reach is wide, and the longest segment is long, at most. */
const REACH_CELLS = 7
/** From the centre of a cell to its corners, in cells, with a margin for rounding. */
const CELL_RADIUS = 0.5005 * Math.sqrt(3)
/** Cells in which a box is searched for lines at most. */
const MOST_SEARCHED = 4096
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

/** Finds lines near positions on the skin, by a grid of cells. Nothing is allocated by `visit`. */
export class LineGrid {
  readonly #reaches: readonly number[]
  /** Side of a cell in millimetres. */
  readonly #cell: number
  readonly #segments: Float64Array
  /** Of each segment its line, and the point it starts from. */
  readonly #lineOf: Int32Array
  readonly #pointOf: Int32Array
  /** Segments by cell. */
  readonly #cells = new Map<number, number[]>()
  /** Of each line that a visit comes across: squared distance (-1 for none), nearest segment, position along it. */
  readonly #squares: Float64Array
  readonly #nearest: Int32Array
  readonly #t: Float64Array
  /** The lines that a visit comes across. */
  readonly #found: Int32Array

  /** @param reaches how far away each line is found, in millimetres. */
  constructor(lines: readonly SkinLine[], reaches: readonly number[]) {
    this.#reaches = reaches
    const farthest = reaches.reduce((a, b) => Math.max(a, b), 0)
    const longest = lines.reduce((most, line) => Math.max(most, longestSegment(line)), 0)
    this.#cell = Math.max(MIN_CELL, (2 * farthest) / REACH_CELLS, longest / REACH_CELLS)
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
        this.#addToCells(segment++)
      }
    }
  }

  /** Whether lines may be within reach of a box. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    const from = [0, 1, 2].map((k) => this.#cellOf(low[k]))
    const to = [0, 1, 2].map((k) => this.#cellOf(high[k]))
    // A large box is not worth the search.
    if (from.reduce((count, cell, k) => count * (to[k] - cell + 1), 1) > MOST_SEARCHED) return true
    for (let x = from[0]; x <= to[0]; x++) {
      for (let y = from[1]; y <= to[1]; y++) {
        for (let z = from[2]; z <= to[2]; z++) if (this.#cells.has(keyOf(x, y, z))) return true
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
    const cell = this.#cells.get(keyOf(this.#cellOf(x), this.#cellOf(y), this.#cellOf(z)))
    if (!cell) return
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
      const side = this.#sideOf(segment, x, y, z, distance)
      visit(line, distance, this.#pointOf[segment], this.#t[line], side)
    }
  }

  /** Distance to the right of the segment's line, over the distance from the segment: (segment x offset) . normal is on the left. */
  #sideOf(segment: number, x: number, y: number, z: number, distance: number): number {
    if (distance === 0) return 0
    const s = this.#segments
    const k = STRIDE * segment
    const vx = x - s[k]
    const vy = y - s[k + 1]
    const vz = z - s[k + 2]
    const left =
      s[k + 7] * (s[k + 4] * vz - s[k + 5] * vy) +
      s[k + 8] * (s[k + 5] * vx - s[k + 3] * vz) +
      s[k + 9] * (s[k + 3] * vy - s[k + 4] * vx)
    return clamp((-left * Math.sqrt(s[k + 6])) / distance, -1, 1)
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

  /** From the centre of a cell to a segment. */
  #distanceTo(segment: number, cellX: number, cellY: number, cellZ: number): number {
    const s = this.#segments
    const k = STRIDE * segment
    const x = (cellX + 0.5) * this.#cell - s[k]
    const y = (cellY + 0.5) * this.#cell - s[k + 1]
    const z = (cellZ + 0.5) * this.#cell - s[k + 2]
    const along = (s[k + 3] * x + s[k + 4] * y + s[k + 5] * z) * s[k + 6]
    const t = along < 0 ? 0 : along > 1 ? 1 : along
    return Math.hypot(x - t * s[k + 3], y - t * s[k + 4], z - t * s[k + 5])
  }

  #addToCells(segment: number): void {
    const reach = this.#reaches[this.#lineOf[segment]]
    const bound = (k: number, isUpper: boolean) => {
      const start = this.#segments[STRIDE * segment + k]
      const end = start + this.#segments[STRIDE * segment + 3 + k]
      return this.#cellOf(isUpper ? Math.max(start, end) + reach : Math.min(start, end) - reach)
    }
    for (let x = bound(0, false); x <= bound(0, true); x++) {
      for (let y = bound(1, false); y <= bound(1, true); y++) {
        for (let z = bound(2, false); z <= bound(2, true); z++) {
          if (this.#distanceTo(segment, x, y, z) > reach + CELL_RADIUS * this.#cell) continue
          const key = keyOf(x, y, z)
          const cell = this.#cells.get(key)
          if (cell) cell.push(segment)
          else this.#cells.set(key, [segment])
        }
      }
    }
  }

  #cellOf(millimetres: number): number {
    return Math.floor(millimetres / this.#cell)
  }
}

function longestSegment({ points }: SkinLine): number {
  let longest = 0
  for (let i = 3; i < points.length; i += 3) {
    const [x, y, z] = [0, 1, 2].map((k) => points[i + k] - points[i - 3 + k])
    longest = Math.max(longest, Math.hypot(x, y, z))
  }
  return longest
}

function keyOf(x: number, y: number, z: number): number {
  return ((x + 512) * 1024 + (y + 512)) * 1024 + (z + 512)
}
