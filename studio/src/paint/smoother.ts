/**
 * Means of values over the space round each position: values are spread over the corners of a grid's cells by trilinear weights, and read in
 * the same way (Chen, Paris and Durand 2007, Real-time edge-aware image processing with the bilateral grid, without the dimension of the
 * values). Positions that are near each other have nearly the same mean, whichever part of the texture they are in.
 */
export class Smoother {
  readonly #cell: number
  readonly #side: number
  readonly #low: readonly [number, number, number]
  readonly #sums: Float64Array
  readonly #weights: Float64Array

  /** @param radius of the ball that holds all positions; `cell` is the side of a cell in the same unit. */
  constructor([x, y, z]: readonly [number, number, number], radius: number, cell: number) {
    this.#cell = cell
    this.#side = Math.ceil((2 * radius) / cell) + 2
    this.#low = [x - radius, y - radius, z - radius]
    this.#sums = new Float64Array(this.#side ** 3)
    this.#weights = new Float64Array(this.#side ** 3)
  }

  /** Adds a value with a weight. */
  add(x: number, y: number, z: number, value: number, weight: number): void {
    this.#visitCorners(x, y, z, (corner, fraction) => {
      this.#sums[corner] += fraction * weight * value
      this.#weights[corner] += fraction * weight
    })
  }

  /** The mean round a position; NaN where there is no value. */
  at(x: number, y: number, z: number): number {
    let [sum, weight] = [0, 0]
    this.#visitCorners(x, y, z, (corner, fraction) => {
      sum += fraction * this.#sums[corner]
      weight += fraction * this.#weights[corner]
    })
    return sum / weight
  }

  #visitCorners(x: number, y: number, z: number, visit: (corner: number, fraction: number) => void): void {
    const side = this.#side
    const [lowX, lowY, lowZ] = this.#low
    const [gx, gy, gz] = [(x - lowX) / this.#cell, (y - lowY) / this.#cell, (z - lowZ) / this.#cell]
    const [i, j, k] = [Math.floor(gx), Math.floor(gy), Math.floor(gz)]
    if (!(i >= 0 && j >= 0 && k >= 0 && i + 1 < side && j + 1 < side && k + 1 < side)) return
    const [fx, fy, fz] = [gx - i, gy - j, gz - k]
    const first = (k * side + j) * side + i
    for (let n = 0; n < 8; n++) {
      const [a, b, c] = [n & 1, (n >> 1) & 1, n >> 2]
      const fraction = (a ? fx : 1 - fx) * (b ? fy : 1 - fy) * (c ? fz : 1 - fz)
      visit(first + (c * side + b) * side + a, fraction)
    }
  }
}
