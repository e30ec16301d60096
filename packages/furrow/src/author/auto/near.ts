import type { Crease } from './crease.ts'

/** Side of a cell in millimetres. */
const CELL = 4
/** From its middle to its corners, and a little more for rounding. */
const CELL_RADIUS = 2.001 * Math.sqrt(3)
/** Cosine between normals below which two places face different ways: a lip is not the other one. */
const FACING = 0.25
/** Numbers of a piece: where it begins, its way, one over its squared length, its normal. */
const PIECE = 10

/**
 * What is nearest on a crease.
 *
 * @param crease its number.
 * @param piece number of the point before it, and how far on towards the next, 0..1.
 * @param side -1 on its left, 1 on its right, seen from outside; 0 on it.
 */
export type Visit = (crease: number, distance: number, piece: number, share: number, side: number) => void

/** Finds creases near places of the skin. Nothing is allocated by `visit`. */
export class NearCreases {
  readonly #reaches: readonly number[]
  readonly #pieces: Float64Array
  /** For each piece the number of its crease, and of the point before it. */
  readonly #creaseOf: Int32Array
  readonly #pointOf: Int32Array
  /** Pieces by cell. */
  readonly #cells = new Map<number, number[]>()
  /** Of the creases that the last visit came upon. */
  readonly #squares: Float64Array
  readonly #nearest: Int32Array
  readonly #shares: Float64Array
  readonly #met: Int32Array

  /** @param reaches how far each can be found, in millimetres. */
  constructor(creases: readonly Pick<Crease, 'points' | 'normals'>[], reaches: readonly number[]) {
    this.#reaches = reaches
    const total = creases.reduce((sum, { points }) => sum + Math.max(0, points.length / 3 - 1), 0)
    this.#pieces = new Float64Array(PIECE * total)
    this.#creaseOf = new Int32Array(total)
    this.#pointOf = new Int32Array(total)
    this.#squares = new Float64Array(creases.length).fill(-1)
    this.#nearest = new Int32Array(creases.length)
    this.#shares = new Float64Array(creases.length)
    this.#met = new Int32Array(creases.length)
    let piece = 0
    for (const [crease, { points, normals }] of creases.entries()) {
      for (let point = 0; point + 1 < points.length / 3; point++) {
        this.#creaseOf[piece] = crease
        this.#pointOf[piece] = point
        this.#store(piece, points, normals)
        this.#file(piece++)
      }
    }
  }

  /** Whether any may lie near a box, for skipping. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    for (let x = cellOf(low[0]!); x <= cellOf(high[0]!); x++) {
      for (let y = cellOf(low[1]!); y <= cellOf(high[1]!); y++) {
        for (let z = cellOf(low[2]!); z <= cellOf(high[2]!); z++)
          if (this.#cells.has(keyOf(x, y, z))) return true
      }
    }
    return false
  }

  /** Visits each crease within reach once, at its nearest point. */
  visit(x: number, y: number, z: number, nx: number, ny: number, nz: number, visit: Visit): void {
    const cell = this.#cells.get(keyOf(cellOf(x), cellOf(y), cellOf(z)))
    if (!cell) return
    const p = this.#pieces
    let met = 0
    for (let i = 0; i < cell.length; i++) {
      const piece = cell[i]!
      const at = PIECE * piece
      if (p[at + 7]! * nx + p[at + 8]! * ny + p[at + 9]! * nz < FACING) continue
      const vx = x - p[at]!
      const vy = y - p[at + 1]!
      const vz = z - p[at + 2]!
      const along = (p[at + 3]! * vx + p[at + 4]! * vy + p[at + 5]! * vz) * p[at + 6]!
      const share = along < 0 ? 0 : along > 1 ? 1 : along
      const dx = vx - share * p[at + 3]!
      const dy = vy - share * p[at + 4]!
      const dz = vz - share * p[at + 5]!
      const square = dx * dx + dy * dy + dz * dz
      const crease = this.#creaseOf[piece]!
      if (this.#squares[crease]! < 0) this.#met[met++] = crease
      else if (square >= this.#squares[crease]!) continue
      this.#squares[crease] = square
      this.#nearest[crease] = piece
      this.#shares[crease] = share
    }
    for (let i = 0; i < met; i++) {
      const crease = this.#met[i]!
      const distance = Math.sqrt(this.#squares[crease]!)
      this.#squares[crease] = -1
      if (distance >= this.#reaches[crease]!) continue
      const piece = this.#nearest[crease]!
      visit(crease, distance, this.#pointOf[piece]!, this.#shares[crease]!, this.#sideOf(piece, x, y, z))
    }
  }

  /** The sign of (way x offset) . normal. */
  #sideOf(piece: number, x: number, y: number, z: number): number {
    const p = this.#pieces
    const at = PIECE * piece
    const vx = x - p[at]!
    const vy = y - p[at + 1]!
    const vz = z - p[at + 2]!
    const left =
      p[at + 7]! * (p[at + 4]! * vz - p[at + 5]! * vy) +
      p[at + 8]! * (p[at + 5]! * vx - p[at + 3]! * vz) +
      p[at + 9]! * (p[at + 3]! * vy - p[at + 4]! * vx)
    return left === 0 ? 0 : left > 0 ? -1 : 1
  }

  #store(piece: number, points: Float64Array, normals: Float64Array): void {
    const from = 3 * this.#pointOf[piece]!
    let square = 0
    for (let k = 0; k < 3; k++) {
      const way = points[from + 3 + k]! - points[from + k]!
      this.#pieces[PIECE * piece + k] = points[from + k]!
      this.#pieces[PIECE * piece + 3 + k] = way
      this.#pieces[PIECE * piece + 7 + k] = normals[from + k]!
      square += way * way
    }
    this.#pieces[PIECE * piece + 6] = square > 0 ? 1 / square : 0
  }

  /** From the middle of a cell to a piece. */
  #distanceTo(piece: number, cellX: number, cellY: number, cellZ: number): number {
    const p = this.#pieces
    const at = PIECE * piece
    const x = (cellX + 0.5) * CELL - p[at]!
    const y = (cellY + 0.5) * CELL - p[at + 1]!
    const z = (cellZ + 0.5) * CELL - p[at + 2]!
    const along = (p[at + 3]! * x + p[at + 4]! * y + p[at + 5]! * z) * p[at + 6]!
    const share = along < 0 ? 0 : along > 1 ? 1 : along
    return Math.hypot(x - share * p[at + 3]!, y - share * p[at + 4]!, z - share * p[at + 5]!)
  }

  #file(piece: number): void {
    const reach = this.#reaches[this.#creaseOf[piece]!]!
    const bound = (k: number, high: boolean) => {
      const start = this.#pieces[PIECE * piece + k]!
      const end = start + this.#pieces[PIECE * piece + 3 + k]!
      return cellOf(high ? Math.max(start, end) + reach : Math.min(start, end) - reach)
    }
    for (let x = bound(0, false); x <= bound(0, true); x++) {
      for (let y = bound(1, false); y <= bound(1, true); y++) {
        for (let z = bound(2, false); z <= bound(2, true); z++) {
          if (this.#distanceTo(piece, x, y, z) > reach + CELL_RADIUS) continue
          const key = keyOf(x, y, z)
          const cell = this.#cells.get(key)
          if (cell) cell.push(piece)
          else this.#cells.set(key, [piece])
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
