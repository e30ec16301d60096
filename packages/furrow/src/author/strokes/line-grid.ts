import type { Crease } from '../auto/lines/crease.ts'

/** Side of a cell in millimetres. */
const CELL = 4
/** From the centre of a cell to its corners, with a margin for rounding. */
const CELL_RADIUS = 2.001 * Math.sqrt(3)
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

/** Finds creases near positions on the skin, by a grid of cells. Nothing is allocated by `visit`. */
export class CreaseGrid {
  readonly #reaches: readonly number[]
  readonly #segments: Float64Array
  /** Of each segment its crease, and the point it starts from. */
  readonly #creaseOf: Int32Array
  readonly #pointOf: Int32Array
  /** Segments by cell. */
  readonly #cells = new Map<number, number[]>()
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
        this.#addToCells(segment++)
      }
    }
  }

  /** Whether creases may be within reach of a box. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    for (let x = cellOf(low[0]); x <= cellOf(high[0]); x++) {
      for (let y = cellOf(low[1]); y <= cellOf(high[1]); y++) {
        for (let z = cellOf(low[2]); z <= cellOf(high[2]); z++)
          if (this.#cells.has(keyOf(x, y, z))) return true
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
    const cell = this.#cells.get(keyOf(cellOf(x), cellOf(y), cellOf(z)))
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

  /** From the centre of a cell to a segment. */
  #distanceTo(segment: number, cellX: number, cellY: number, cellZ: number): number {
    const s = this.#segments
    const k = STRIDE * segment
    const x = (cellX + 0.5) * CELL - s[k]
    const y = (cellY + 0.5) * CELL - s[k + 1]
    const z = (cellZ + 0.5) * CELL - s[k + 2]
    const along = (s[k + 3] * x + s[k + 4] * y + s[k + 5] * z) * s[k + 6]
    const t = along < 0 ? 0 : along > 1 ? 1 : along
    return Math.hypot(x - t * s[k + 3], y - t * s[k + 4], z - t * s[k + 5])
  }

  #addToCells(segment: number): void {
    const reach = this.#reaches[this.#creaseOf[segment]]
    const bound = (k: number, isUpper: boolean) => {
      const start = this.#segments[STRIDE * segment + k]
      const end = start + this.#segments[STRIDE * segment + 3 + k]
      return cellOf(isUpper ? Math.max(start, end) + reach : Math.min(start, end) - reach)
    }
    for (let x = bound(0, false); x <= bound(0, true); x++) {
      for (let y = bound(1, false); y <= bound(1, true); y++) {
        for (let z = bound(2, false); z <= bound(2, true); z++) {
          if (this.#distanceTo(segment, x, y, z) > reach + CELL_RADIUS) continue
          const key = keyOf(x, y, z)
          const cell = this.#cells.get(key)
          if (cell) cell.push(segment)
          else this.#cells.set(key, [segment])
        }
      }
    }
  }
}

function cellOf(millimetres: number): number {
  return Math.floor(millimetres / CELL)
}

function keyOf(x: number, y: number, z: number): number {
  return ((x + 512) * 1024 + (y + 512)) * 1024 + (z + 512)
}
