/**
 * Computes local means of values at positions in space. Adds the values to a grid and reads the means from it, both with trilinear weights. The
 * grid divides 3D space, so UV seams have no effect. This is the bilateral grid of Chen, Paris and Durand (2007, Real-time edge-aware
 * image processing with the bilateral grid) without its range dimension.
 */
export class Smoother {
  readonly #cell: number
  readonly #side: number
  readonly #low: readonly [number, number, number]
  readonly #sums: Float64Array
  readonly #weights: Float64Array
  /** Index offsets from a cell's lowest corner to each of its eight corners. */
  readonly #steps: readonly number[]
  readonly #fractions = new Float64Array(8)

  /** @param radius radius of the sphere that contains all positions. @param cell width of a cell, in the same unit. */
  constructor([x, y, z]: readonly [number, number, number], radius: number, cell: number) {
    this.#cell = cell
    this.#side = Math.ceil((2 * radius) / cell) + 2
    this.#low = [x - radius, y - radius, z - radius]
    const side = this.#side
    this.#steps = [0, side * side].flatMap((up) => [0, 1, side, side + 1].map((step) => up + step))
    this.#sums = new Float64Array(side ** 3)
    this.#weights = new Float64Array(side ** 3)
  }

  add(x: number, y: number, z: number, value: number, weight: number): void {
    const first = this.#locate(x, y, z)
    if (first < 0) return
    for (let n = 0; n < 8; n++) {
      const corner = first + this.#steps[n]
      this.#sums[corner] += this.#fractions[n] * weight * value
      this.#weights[corner] += this.#fractions[n] * weight
    }
  }

  /** Returns the mean around a position, or NaN if there are no values nearby. */
  at(x: number, y: number, z: number): number {
    const first = this.#locate(x, y, z)
    let [sum, weight] = [0, 0]
    for (let n = 0; first >= 0 && n < 8; n++) {
      const corner = first + this.#steps[n]
      sum += this.#fractions[n] * this.#sums[corner]
      weight += this.#fractions[n] * this.#weights[corner]
    }
    return sum / weight
  }

  /** Returns the index of the lowest corner of the cell at a position, or -1 outside the grid. Sets `#fractions`, the weights of the corners. */
  #locate(x: number, y: number, z: number): number {
    const side = this.#side
    const gx = (x - this.#low[0]) / this.#cell
    const gy = (y - this.#low[1]) / this.#cell
    const gz = (z - this.#low[2]) / this.#cell
    const i = Math.floor(gx)
    const j = Math.floor(gy)
    const k = Math.floor(gz)
    if (!(i >= 0 && j >= 0 && k >= 0 && i + 1 < side && j + 1 < side && k + 1 < side)) return -1
    for (let n = 0; n < 8; n++) {
      const alongX = n & 1 ? gx - i : 1 - gx + i
      const alongY = n & 2 ? gy - j : 1 - gy + j
      const alongZ = n & 4 ? gz - k : 1 - gz + k
      this.#fractions[n] = alongX * alongY * alongZ
    }
    return (k * side + j) * side + i
  }
}
