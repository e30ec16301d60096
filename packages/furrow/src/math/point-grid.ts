import { length3 } from './vector.ts'

const NONE: readonly number[] = []
/** Factor that allows for rounding errors of a squared distance. */
const ROUNDING = 1 + 1e-12
/** Numbers stored per point of a cell: x, y, z, index. */
const STRIDE = 4

/** Receives the index of a point and its squared distance from the position. Points are numbered in the order of insertion. */
export type PointVisitor = (point: number, square: number) => void

/** Spatial hash of 3D points. A search finds all points whose distance is at most the edge length of a cell. */
export class PointGrid {
  readonly #side: number
  readonly #cells = new Map<number, number[]>()
  /** Scratch: cells around a position. */
  readonly #around: (readonly number[])[] = []
  #count = 0

  /** @param side edge length of a cell. */
  constructor(side: number) {
    this.#side = side
  }

  /** @param points packed xyz. */
  add(points: ArrayLike<number>): void {
    for (let i = 0; i < points.length; i += 3) {
      const key = hash(this.#index(points[i]), this.#index(points[i + 1]), this.#index(points[i + 2]))
      const cell = this.#cells.get(key)
      if (cell) cell.push(points[i], points[i + 1], points[i + 2], this.#count)
      else this.#cells.set(key, [points[i], points[i + 1], points[i + 2], this.#count])
      this.#count++
    }
  }

  /** Returns the distance to the nearest point. If it exceeds the edge length of a cell, the result may be too large or infinite. */
  distance(position: ArrayLike<number>): number {
    let nearest = Infinity
    for (const cell of this.#cellsAround(position)) {
      for (let n = 0; n < cell.length; n += STRIDE) {
        const dx = cell[n] - position[0]
        const dy = cell[n + 1] - position[1]
        const dz = cell[n + 2] - position[2]
        // This test is faster than a call of `length3`.
        if (dx * dx + dy * dy + dz * dz > ROUNDING * nearest ** 2) continue
        nearest = Math.min(nearest, length3(dx, dy, dz))
      }
    }
    return nearest
  }

  /** Visits all points whose distance is at most the edge length of a cell, and some points farther away. A point may be visited twice. */
  visitNear(position: ArrayLike<number>, visit: PointVisitor): void {
    for (const cell of this.#cellsAround(position)) {
      for (let n = 0; n < cell.length; n += STRIDE) {
        const dx = cell[n] - position[0]
        const dy = cell[n + 1] - position[1]
        const dz = cell[n + 2] - position[2]
        visit(cell[n + 3], dx * dx + dy * dy + dz * dz)
      }
    }
  }

  /** Returns the cell that contains a position, and its 26 neighbours. */
  #cellsAround(position: ArrayLike<number>): readonly (readonly number[])[] {
    const [x, y, z] = [this.#index(position[0]), this.#index(position[1]), this.#index(position[2])]
    let count = 0
    for (let i = -1; i <= 1; i++) {
      for (let j = -1; j <= 1; j++) {
        for (let k = -1; k <= 1; k++)
          this.#around[count++] = this.#cells.get(hash(x + i, y + j, z + k)) ?? NONE
      }
    }
    return this.#around
  }

  #index(coordinate: number): number {
    return Math.floor(coordinate / this.#side)
  }
}

/** Returns the key of a cell. If two cells have the same key, a search visits the points of both cells. */
function hash(x: number, y: number, z: number): number {
  return Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)
}
