import type { Crease } from './crease.ts'

/** Side of a cell in millimetres. */
const CELL = 4
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
 * Is given the point of a crease that is nearest.
 *
 * @param crease its index.
 * @param distance in millimetres.
 * @param segment index of the point before it.
 * @param t how far it is along the segment, 0..1.
 * @param side -1 where the position is on the left of the crease, 1 on its right, seen from outside; 0 on it.
 */
export type CreaseVisitor = (
  crease: number,
  distance: number,
  segment: number,
  t: number,
  side: number,
) => void

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
 * Finds creases near positions on the skin, by a grid of cells that are filled when they are first asked for, since skin has few of those
 * that are within reach of a crease: each from the cube of cells that it is in, that one from a larger one, the largest from all segments.
 */
export class CreaseGrid {
  readonly #reaches: readonly number[]
  readonly #segments: Float64Array
  /** Of each segment its crease, and the point it starts from. */
  readonly #creaseOf: Int32Array
  readonly #pointOf: Int32Array
  /** From the cells up. */
  readonly #levels: readonly Level[]
  /** All segments. */
  readonly #all: readonly number[]
  /** The first and last cell within reach of any crease, along each axis. */
  readonly #low = [Infinity, Infinity, Infinity]
  readonly #high = [-Infinity, -Infinity, -Infinity]
  /** Of each crease that a visit comes across: squared distance (-1 for none), nearest segment, position along it. */
  readonly #squares: Float64Array
  readonly #nearest: Int32Array
  readonly #t: Float64Array
  /** The creases that a visit comes across. */
  readonly #found: Int32Array

  /** @param reaches how far away each crease is found, in millimetres. */
  constructor(creases: readonly Pick<Crease, 'points' | 'normals'>[], reaches: readonly number[]) {
    this.#reaches = reaches
    const total = creases.reduce((sum, { points }) => sum + Math.max(0, points.length / 3 - 1), 0)
    this.#segments = new Float64Array(STRIDE * total)
    this.#creaseOf = new Int32Array(total)
    this.#pointOf = new Int32Array(total)
    this.#squares = new Float64Array(creases.length).fill(-1)
    this.#nearest = new Int32Array(creases.length)
    this.#t = new Float64Array(creases.length)
    this.#found = new Int32Array(creases.length)
    let segment = 0
    for (const [crease, { points, normals }] of creases.entries()) {
      for (let point = 0; point + 1 < points.length / 3; point++) {
        this.#creaseOf[segment] = crease
        this.#pointOf[segment] = point
        this.#store(segment, points, normals)
        this.#widen(segment++)
      }
    }
    this.#all = Array.from({ length: total }, (_, i) => i)
    this.#levels = this.#levelsOf()
  }

  /** Whether creases may be within reach of a box. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    const [left, right] = [Math.max(cellOf(low[0]), this.#low[0]), Math.min(cellOf(high[0]), this.#high[0])]
    const [bottom, top] = [Math.max(cellOf(low[1]), this.#low[1]), Math.min(cellOf(high[1]), this.#high[1])]
    const [back, front] = [Math.max(cellOf(low[2]), this.#low[2]), Math.min(cellOf(high[2]), this.#high[2])]
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
   * Visits each crease within reach once, at its nearest point.
   *
   * @param x, y, z a position on the skin.
   * @param nx, ny, nz the skin's normal there.
   */
  visit(x: number, y: number, z: number, nx: number, ny: number, nz: number, visit: CreaseVisitor): void {
    const cell = this.#cellAt(cellOf(x), cellOf(y), cellOf(z))
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
      const crease = this.#creaseOf[segment]
      if (this.#squares[crease] < 0) this.#found[found++] = crease
      else if (square >= this.#squares[crease]) continue
      this.#squares[crease] = square
      this.#nearest[crease] = segment
      this.#t[crease] = t
    }
    for (let i = 0; i < found; i++) {
      const crease = this.#found[i]
      const distance = Math.sqrt(this.#squares[crease])
      this.#squares[crease] = -1
      if (distance >= this.#reaches[crease]) continue
      const segment = this.#nearest[crease]
      visit(crease, distance, this.#pointOf[segment], this.#t[crease], this.#sideOf(segment, x, y, z))
    }
  }

  /** The sign of (segment x offset) . normal. */
  #sideOf(segment: number, x: number, y: number, z: number): number {
    const s = this.#segments
    const k = STRIDE * segment
    const vx = x - s[k]
    const vy = y - s[k + 1]
    const vz = z - s[k + 2]
    const left =
      s[k + 7] * (s[k + 4] * vz - s[k + 5] * vy) +
      s[k + 8] * (s[k + 5] * vx - s[k + 3] * vz) +
      s[k + 9] * (s[k + 3] * vy - s[k + 4] * vx)
    return left === 0 ? 0 : left > 0 ? -1 : 1
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

  /** Widens the box within reach of any crease by a segment. */
  #widen(segment: number): void {
    const reach = this.#reaches[this.#creaseOf[segment]]
    for (let k = 0; k < 3; k++) {
      const start = this.#segments[STRIDE * segment + k]
      const end = start + this.#segments[STRIDE * segment + 3 + k]
      this.#low[k] = Math.min(this.#low[k], cellOf(Math.min(start, end) - reach))
      this.#high[k] = Math.max(this.#high[k], cellOf(Math.max(start, end) + reach))
    }
  }

  /** The segments whose creases may be within reach of a cell. */
  #cellAt(x: number, y: number, z: number): readonly number[] {
    const [low, high] = [this.#low, this.#high]
    // Not the other way round: NaN is nowhere.
    if (!(x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] && z <= high[2]))
      return NONE
    return this.#cubeAt(0, x, y, z)
  }

  /** The segments whose creases may be within reach of a cube, given by its index along each axis. */
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

  /** Up to the level whose cubes are nearly as large as all that is within reach of any crease. */
  #levelsOf(): Level[] {
    const levels: Level[] = []
    const extent = Math.max(...this.#high.map((high, k) => high - this.#low[k]))
    let cells = 1
    do {
      const [low, high] = [this.#low, this.#high].map((box) => box.map((cell) => Math.floor(cell / cells)))
      const [, rows, layers] = high.map((last, k) => last - low[k] + 1)
      levels.push({ side: cells * CELL, low, rows, layers, cubes: new Map() })
      cells *= BRANCHING
    } while (cells < extent)
    return levels
  }

  /** Those of some segments whose creases may be within reach of a cube, given by its index along each axis and its side. */
  #within(segments: readonly number[], x: number, y: number, z: number, side: number): readonly number[] {
    const radius = (side / 2) * RADIUS
    const [px, py, pz] = [(x + 0.5) * side, (y + 0.5) * side, (z + 0.5) * side]
    return segments.filter(
      (segment) =>
        this.#squareTo(segment, px, py, pz) <= (this.#reaches[this.#creaseOf[segment]] + radius) ** 2,
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
}

const NONE: readonly number[] = []

function cellOf(millimetres: number): number {
  return Math.floor(millimetres / CELL)
}
