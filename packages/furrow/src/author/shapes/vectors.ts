/** x, y and z. */
export type Vector = readonly [number, number, number]

export const plus = (a: Vector, b: Vector, scale = 1): Vector => [
  a[0] + scale * b[0],
  a[1] + scale * b[1],
  a[2] + scale * b[2],
]

export const minus = (a: Vector, b: Vector): Vector => plus(a, b, -1)

export const dotOf = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

export const crossed = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

export const lengthOf = (a: Vector): number => Math.sqrt(dotOf(a, a))

export const unit = (a: Vector): Vector => plus([0, 0, 0], a, 1 / (lengthOf(a) || 1))

/** Removes the component of a vector along a unit axis. */
export const across = (a: Vector, axis: Vector): Vector => plus(a, axis, -dotOf(a, axis))

export const vectorAt = (values: ArrayLike<number>, i: number): Vector => [
  values[3 * i],
  values[3 * i + 1],
  values[3 * i + 2],
]

/** Interpolates the values `ys` at the ascending positions `xs` linearly. Outside the positions, returns the first or the last value. */
export function interpolated(x: number, xs: ArrayLike<number>, ys: ArrayLike<number>): number {
  const last = xs.length - 1
  if (!(x > xs[0])) return ys[0]
  if (x >= xs[last]) return ys[last]
  let i = 0
  while (x > xs[i + 1]) i++
  return ys[i] + ((x - xs[i]) / (xs[i + 1] - xs[i])) * (ys[i + 1] - ys[i])
}
