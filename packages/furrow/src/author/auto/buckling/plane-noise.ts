import { hash32 } from '../../../math/hash.ts'
import { clamp } from '../../../math/scalar.ts'
import { splineWeights } from './spline-weights.ts'

/**
 * Standard deviation of a cubic B-spline whose coefficients are uniform in -1..1. The standard deviation of the coefficients is `sqrt(1/3)`.
 * Each of the two dimensions contributes a factor `sqrt(151/315)`, where 151/315 is the integral of the squared basis function.
 */
const DEVIATION = (151 / 315) * Math.sqrt(1 / 3)
/** Standard deviation of the cubic B-spline basis function, in knot distances. */
const BASIS_SIGMA = Math.sqrt(1 / 3)
/** Limit of `planeNoise` in standard deviations. */
export const NOISE_LIMIT = 2

const [rows, columns] = [new Float64Array(4), new Float64Array(4)]

/**
 * Evaluates a smooth random field over the plane. Its mean is 0, its standard deviation is 1, and its values are limited to -2..2. The value
 * depends only on position and seed, so grids of any spacing sample the same field.
 *
 * @param correlation standard deviation of a bump, in the unit of x and y.
 */
export function planeNoise(x: number, y: number, correlation: number, seed: number): number {
  const scale = BASIS_SIGMA / correlation
  const left = Math.floor(scale * x)
  const top = Math.floor(scale * y)
  splineWeights(columns, scale * x - left)
  splineWeights(rows, scale * y - top)
  let sum = 0
  for (let row = 0; row < 4; row++) {
    for (let column = 0; column < 4; column++)
      sum += rows[row] * columns[column] * randomAt(left + column, top + row, seed)
  }
  return clamp(sum / DEVIATION, -NOISE_LIMIT, NOISE_LIMIT)
}

/** Returns a random number in -1..1 for a lattice point. */
function randomAt(column: number, row: number, seed: number): number {
  const key = Math.imul(column, 0x9e3779b1) ^ Math.imul(row, 0x85ebca6b) ^ hash32(seed)
  return hash32(key) / 0x7fffffff - 1
}
