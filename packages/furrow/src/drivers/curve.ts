import type { Curve } from '../core/driver-types.ts'

/** A piecewise-linear curve, constant beyond its ends. NaN counts as the least input. */
export function curveAt(curve: Readonly<Curve>, input: number): number {
  if (!(input > curve[0][0])) return curve[0][1]
  for (let i = 1; i < curve.length; i++) {
    if (input > curve[i][0]) continue
    const share = (input - curve[i - 1][0]) / (curve[i][0] - curve[i - 1][0])
    return curve[i - 1][1] * (1 - share) + curve[i][1] * share
  }
  return curve[curve.length - 1][1]
}
