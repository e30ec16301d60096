/** Points in space, for the distance to the nearest within the side of a cell. */
export class PointGrid {
  readonly #side: number
  readonly #cells = new Map<string, number[]>()

  constructor(side: number) {
    this.#side = side
  }

  /** @param points x, y and z of each. */
  add(points: ArrayLike<number>): void {
    for (let i = 0; i < points.length; i += 3) {
      const key = this.#cellOf(points[i], points[i + 1], points[i + 2]).join(' ')
      const cell = this.#cells.get(key)
      if (cell) cell.push(points[i], points[i + 1], points[i + 2])
      else this.#cells.set(key, [points[i], points[i + 1], points[i + 2]])
    }
  }

  /** Infinity where no point is in the cell of a position or those around it. */
  distance(position: ArrayLike<number>): number {
    const [x, y, z] = this.#cellOf(position[0], position[1], position[2])
    let nearest = Infinity
    for (let i = x - 1; i <= x + 1; i++) {
      for (let j = y - 1; j <= y + 1; j++) {
        for (let k = z - 1; k <= z + 1; k++) {
          const cell = this.#cells.get(`${i} ${j} ${k}`) ?? []
          for (let n = 0; n < cell.length; n += 3) {
            const distance = Math.hypot(
              cell[n] - position[0],
              cell[n + 1] - position[1],
              cell[n + 2] - position[2],
            )
            nearest = Math.min(nearest, distance)
          }
        }
      }
    }
    return nearest
  }

  #cellOf(x: number, y: number, z: number): number[] {
    return [Math.floor(x / this.#side), Math.floor(y / this.#side), Math.floor(z / this.#side)]
  }
}
