import { clamp } from '../../../math/scalar.ts'

const ITERATIONS = 60
/** Weight of the term with the prior, per row of the matrix (Tikhonov regularisation). */
const RIDGE = 0.02

export type Bounds = readonly [low: number, high: number]

/**
 * Finds the weights w within bounds that minimise `|A * w - b|^2 + ridge * |w - prior|^2`. The prior decides where A does not determine the
 * weights. The method is projected Gauss-Seidel on the normal equations (Murty: Linear Complementarity, 9.3).
 *
 * @param rows rows of the matrix A.
 * @param prior expected weights.
 * @param bounds minimum and maximum of each weight.
 */
export function boundedLeastSquares(
  rows: readonly number[][],
  b: readonly number[],
  prior: readonly number[],
  bounds: readonly Bounds[],
): number[] {
  const ridge = RIDGE * rows.length
  const matrix = prior.map((_, i) =>
    prior.map((_, j) => rows.reduce((sum, row) => sum + row[i] * row[j], i === j ? ridge : 0)),
  )
  const right = prior.map((value, i) => rows.reduce((sum, row, k) => sum + row[i] * b[k], ridge * value))
  const weights = prior.map(() => 0)
  for (let iteration = 0; iteration < ITERATIONS; iteration++) {
    for (let i = 0; i < weights.length; i++) {
      let rest = right[i]
      for (let j = 0; j < weights.length; j++) if (j !== i) rest -= matrix[i][j] * weights[j]
      weights[i] = clamp(rest / matrix[i][i], ...bounds[i])
    }
  }
  return weights
}
