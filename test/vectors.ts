/** Operations on vectors of three numbers. */

export type Vector = [x: number, y: number, z: number]

export const vectorAt = (values: ArrayLike<number>, i: number): Vector => [
  values[3 * i],
  values[3 * i + 1],
  values[3 * i + 2],
]

export const scaled = (v: Vector, factor: number): Vector => [factor * v[0], factor * v[1], factor * v[2]]

export const plus = (a: Vector, b: Vector, factor = 1): Vector => [
  a[0] + factor * b[0],
  a[1] + factor * b[1],
  a[2] + factor * b[2],
]

export const minus = (a: Vector, b: Vector) => plus(a, b, -1)

export const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

export const unit = (v: Vector) => scaled(v, 1 / Math.hypot(...v))

/** Returns the angle between two vectors, degrees; 0 if either has length 0. */
export const degreesBetween = (a: Vector, b: Vector) =>
  (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / Math.PI
