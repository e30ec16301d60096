/** A point of a piecewise-linear curve: input, output. */
export type CurvePoint = [input: number, output: number]

/** Two or more points with growing inputs; constant beyond its ends. */
export type Curve = CurvePoint[]

/** The identity, within 0..1. */
export const IDENTITY: Readonly<Curve> = [
  [0, 0],
  [1, 1],
]

/** Evaluates a curve. NaN counts as the smallest input. */
export function curveAt(curve: Readonly<Curve>, input: number): number {
  const value = Float64Array.of(input)
  applyCurve(curve, value)
  return value[0]
}

/**
 * The same without allocation: a number that is passed to a function or returned by one may be boxed.
 *
 * @param value one number, which is replaced by the curve's.
 */
export function applyCurve(curve: Readonly<Curve>, value: Float64Array): void {
  const input = value[0]
  value[0] = curve[curve.length - 1][1]
  if (!(input > curve[0][0])) value[0] = curve[0][1]
  else {
    for (let i = 1; i < curve.length; i++) {
      if (input > curve[i][0]) continue
      const t = (input - curve[i - 1][0]) / (curve[i][0] - curve[i - 1][0])
      value[0] = curve[i - 1][1] * (1 - t) + curve[i][1] * t
      return
    }
  }
}
