const NONE: readonly number[] = []
/** More than what rounding adds to the square of a distance. */
const ROUNDING = 1 + 1e-12

/** Points in space, for the distance to the nearest within the side of a cell. */
export class PointGrid {
  readonly #side: number
  readonly #cells = new Map<number, number[]>()

  constructor(side: number) {
    this.#side = side
  }

  /** @param points x, y and z of each. */
  add(points: ArrayLike<number>): void {
    for (let i = 0; i < points.length; i += 3) {
      const key = hash(this.#index(points[i]), this.#index(points[i + 1]), this.#index(points[i + 2]))
      const cell = this.#cells.get(key)
      if (cell) cell.push(points[i], points[i + 1], points[i + 2])
      else this.#cells.set(key, [points[i], points[i + 1], points[i + 2]])
    }
  }

  /** The distance to the nearest point; more than the side of a cell, or infinity, where none is within that side. */
  distance(position: ArrayLike<number>): number {
    const [x, y, z] = [this.#index(position[0]), this.#index(position[1]), this.#index(position[2])]
    let nearest = Infinity
    for (let i = -1; i <= 1; i++) {
      for (let j = -1; j <= 1; j++) {
        for (let k = -1; k <= 1; k++) {
          const cell = this.#cells.get(hash(x + i, y + j, z + k)) ?? NONE
          for (let n = 0; n < cell.length; n += 3) {
            const dx = cell[n] - position[0]
            const dy = cell[n + 1] - position[1]
            const dz = cell[n + 2] - position[2]
            // The hypotenuse costs ten times as much.
            if (dx * dx + dy * dy + dz * dz > ROUNDING * nearest ** 2) continue
            nearest = Math.min(nearest, Math.hypot(dx, dy, dz))
          }
        }
      }
    }
    return nearest
  }

  #index(coordinate: number): number {
    return Math.floor(coordinate / this.#side)
  }
}

/** Cells with the same hash are kept as one: their points are too far apart to count. */
function hash(x: number, y: number, z: number): number {
  return Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)
}
