/** A point of a piecewise-linear curve. */
export type CurvePoint = [input: number, output: number]

/** A piecewise-linear curve: two or more points with increasing inputs. Before the first and after the last point, the output is constant. */
export type Curve = CurvePoint[]

/** Curve that returns the input, clamped to 0..1. */
export const IDENTITY: Readonly<Curve> = [
  [0, 0],
  [1, 1],
]

/** Points of a curve in one flat array: input, output, input, output and so on. Evaluating it is twice as fast as evaluating a `Curve`. */
export type CurvePoints = Float64Array

export function pointsOf(curve: Readonly<Curve>): CurvePoints {
  return Float64Array.from(curve.flat())
}

/** Evaluates a curve at `input`. For NaN, returns the output of the first point. */
export function curveAt(curve: Readonly<Curve>, input: number): number {
  return outputOf(pointsOf(curve), input)
}

/** Evaluates a curve at `input`, without allocation. */
export function outputOf(points: CurvePoints, input: number): number {
  const end = points.length
  let next = 0
  while (next < end && input > points[next]) next += 2
  if (next === 0) return points[1]
  if (next === end) return points[end - 1]
  const t = (input - points[next - 2]) / (points[next] - points[next - 2])
  return points[next - 1] * (1 - t) + points[next + 1] * t
}
