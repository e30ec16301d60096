/** Maximum number of iterations. */
const MAX_ITERATIONS = 400
/** A solution is accepted if its residual is at most this fraction of the right side. */
const TOLERANCE = 1e-7

/** Linear system of the weighted graph Laplacian L of connected triangles. The solver uses conjugate gradients with a diagonal preconditioner. */
export class LaplaceSystem {
  /** For each corner of each triangle, the weight of the edge to the triangle's next corner. */
  readonly weights: Float64Array
  readonly #corners: Uint32Array
  readonly #diagonal: Float64Array

  /** @param count number of points. */
  constructor(corners: Uint32Array, weights: Float64Array, count: number) {
    this.weights = weights
    this.#corners = corners
    this.#diagonal = new Float64Array(count)
    for (let i = 0; i < corners.length; i++) {
      this.#diagonal[corners[i]] += weights[i]
      this.#diagonal[corners[nextCorner(i)]] += weights[i]
    }
  }

  /**
   * Solves L x = right for x. Preserves the mean of x, weighted by the diagonal of L.
   *
   * @param right right side, whose sum must be 0.
   * @param x initial guess; receives the solution.
   */
  solve(right: Float64Array, x: Float64Array): void {
    const count = x.length
    const diagonal = this.#diagonal
    const residual = new Float64Array(count)
    const product = new Float64Array(count)
    this.#multiply(x, product)
    for (let i = 0; i < count; i++) residual[i] = right[i] - product[i]
    const enough = TOLERANCE * TOLERANCE * this.#preconditionedSquare(right)
    const direction = Float64Array.from(residual, (value, i) => value / diagonal[i])
    let square = this.#preconditionedSquare(residual)
    for (let iteration = 0; iteration < MAX_ITERATIONS && square > enough; iteration++) {
      this.#multiply(direction, product)
      let curvature = 0
      for (let i = 0; i < count; i++) curvature += direction[i] * product[i]
      const length = square / curvature
      let next = 0
      for (let i = 0; i < count; i++) {
        x[i] += length * direction[i]
        residual[i] -= length * product[i]
        next += (residual[i] * residual[i]) / diagonal[i]
      }
      const kept = next / square
      for (let i = 0; i < count; i++) direction[i] = residual[i] / diagonal[i] + kept * direction[i]
      square = next
    }
  }

  #multiply(x: Float64Array, out: Float64Array): void {
    const corners = this.#corners
    const weights = this.weights
    out.fill(0)
    for (let i = 0; i < corners.length; i += 3) {
      const a = corners[i]
      const b = corners[i + 1]
      const c = corners[i + 2]
      const ab = weights[i] * (x[a] - x[b])
      const bc = weights[i + 1] * (x[b] - x[c])
      const ca = weights[i + 2] * (x[c] - x[a])
      out[a] = out[a] + ab - ca
      out[b] = out[b] - ab + bc
      out[c] = out[c] - bc + ca
    }
  }

  #preconditionedSquare(values: Float64Array): number {
    let sum = 0
    for (let i = 0; i < values.length; i++) sum += (values[i] * values[i]) / this.#diagonal[i]
    return sum
  }
}

function nextCorner(i: number): number {
  return i % 3 === 2 ? i - 2 : i + 1
}
