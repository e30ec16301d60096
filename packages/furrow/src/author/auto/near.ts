import type { Crease } from './crease.ts'

/** Side of a cell in millimetres. */
const CELL = 4
/** Cosine between normals below which two places face different ways: a lip is not the other one. */
const FACING = 0.25

/**
 * What is nearest on a crease.
 *
 * @param crease its number.
 * @param piece number of the point before it, and how far on towards the next, 0..1.
 * @param side -1 on its left, 1 on its right, seen from outside; 0 on it.
 */
export type Visit = (crease: number, distance: number, piece: number, share: number, side: number) => void

/** Finds creases near places of the skin. */
export class NearCreases {
  readonly #creases: readonly Crease[]
  readonly #reaches: readonly number[]
  /** By cell: pairs of crease and piece. */
  readonly #cells = new Map<number, number[]>()
  readonly #best = new Map<number, [square: number, piece: number, share: number]>()

  /** @param reaches how far each can be found, in millimetres. */
  constructor(creases: readonly Crease[], reaches: readonly number[]) {
    this.#creases = creases
    this.#reaches = reaches
    for (const [crease, { points }] of creases.entries()) {
      for (let piece = 0; piece + 1 < points.length / 3; piece++) this.#file(crease, piece)
    }
  }

  /** Whether any may lie near a box, for skipping. */
  isNear(low: ArrayLike<number>, high: ArrayLike<number>): boolean {
    const first = [0, 1, 2].map((k) => Math.floor(low[k]! / CELL))
    const last = [0, 1, 2].map((k) => Math.floor(high[k]! / CELL))
    for (let x = first[0]!; x <= last[0]!; x++) {
      for (let y = first[1]!; y <= last[1]!; y++) {
        for (let z = first[2]!; z <= last[2]!; z++) if (this.#cells.has(keyOf(x, y, z))) return true
      }
    }
    return false
  }

  /** Visits each crease within reach once, at its nearest point. */
  visit(x: number, y: number, z: number, nx: number, ny: number, nz: number, visit: Visit): void {
    const cell = this.#cells.get(keyOf(Math.floor(x / CELL), Math.floor(y / CELL), Math.floor(z / CELL)))
    if (!cell) return
    const best = this.#best
    best.clear()
    for (let i = 0; i < cell.length; i += 2) {
      const [crease, piece] = [cell[i]!, cell[i + 1]!]
      const { points: p, normals: n } = this.#creases[crease]!
      const a = 3 * piece
      if (n[a]! * nx + n[a + 1]! * ny + n[a + 2]! * nz < FACING) continue
      const [ux, uy, uz] = [p[a + 3]! - p[a]!, p[a + 4]! - p[a + 1]!, p[a + 5]! - p[a + 2]!]
      const [vx, vy, vz] = [x - p[a]!, y - p[a + 1]!, z - p[a + 2]!]
      const share = Math.min(
        Math.max((ux * vx + uy * vy + uz * vz) / (ux * ux + uy * uy + uz * uz || 1), 0),
        1,
      )
      const square = (vx - share * ux) ** 2 + (vy - share * uy) ** 2 + (vz - share * uz) ** 2
      const known = best.get(crease)
      if (!known) best.set(crease, [square, piece, share])
      else if (square < known[0]) {
        known[0] = square
        known[1] = piece
        known[2] = share
      }
    }
    for (const [crease, [square, piece, share]] of best) {
      const distance = Math.sqrt(square)
      if (distance >= this.#reaches[crease]!) continue
      visit(crease, distance, piece, share, this.#sideOf(crease, piece, x, y, z))
    }
  }

  /** The sign of (way x offset) . normal. */
  #sideOf(crease: number, piece: number, x: number, y: number, z: number): number {
    const { points: p, normals: n } = this.#creases[crease]!
    const a = 3 * piece
    const [ux, uy, uz] = [p[a + 3]! - p[a]!, p[a + 4]! - p[a + 1]!, p[a + 5]! - p[a + 2]!]
    const [vx, vy, vz] = [x - p[a]!, y - p[a + 1]!, z - p[a + 2]!]
    const left =
      n[a]! * (uy * vz - uz * vy) + n[a + 1]! * (uz * vx - ux * vz) + n[a + 2]! * (ux * vy - uy * vx)
    return left === 0 ? 0 : left > 0 ? -1 : 1
  }

  #file(crease: number, piece: number): void {
    const { points } = this.#creases[crease]!
    const reach = this.#reaches[crease]!
    const [low, high] = [Math.min, Math.max].map((pick, way) =>
      [0, 1, 2].map((k) => {
        const value = pick(points[3 * piece + k]!, points[3 * piece + 3 + k]!)
        return Math.floor((value + (way === 0 ? -reach : reach)) / CELL)
      }),
    ) as [number[], number[]]
    for (let x = low[0]!; x <= high[0]!; x++) {
      for (let y = low[1]!; y <= high[1]!; y++) {
        for (let z = low[2]!; z <= high[2]!; z++) {
          const key = keyOf(x, y, z)
          const cell = this.#cells.get(key)
          if (cell) cell.push(crease, piece)
          else this.#cells.set(key, [crease, piece])
        }
      }
    }
  }
}

function keyOf(x: number, y: number, z: number): number {
  return ((x + 512) * 1024 + (y + 512)) * 1024 + (z + 512)
}
