import type { Curve } from './types.ts'

/** A piecewise-linear curve, constant beyond its ends. NaN counts as the least input. */
export function curveAt(curve: Readonly<Curve>, input: number): number {
  const value = Float64Array.of(input)
  applyCurve(curve, value)
  return value[0]
}

/**
 * The same for what is done in every frame: a number that is handed to a function or comes back from one may be allocated.
 *
 * @param value one number, which the curve's takes the place of.
 */
export function applyCurve(curve: Readonly<Curve>, value: Float64Array): void {
  const input = value[0]
  value[0] = curve[curve.length - 1][1]
  if (!(input > curve[0][0])) value[0] = curve[0][1]
  else {
    for (let i = 1; i < curve.length; i++) {
      if (input > curve[i][0]) continue
      const share = (input - curve[i - 1][0]) / (curve[i][0] - curve[i - 1][0])
      value[0] = curve[i - 1][1] * (1 - share) + curve[i][1] * share
      return
    }
  }
}
