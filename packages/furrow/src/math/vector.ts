/**
 * Computes the cross product of `a` and `b`. The array `out` must not be `a` or `b`.
 *
 * @param i, j indices of x in `a` and `b`, for packed arrays of vectors.
 */
export function cross(out: Float64Array, a: ArrayLike<number>, b: ArrayLike<number>, i = 0, j = 0): void {
  out[0] = a[i + 1] * b[j + 2] - a[i + 2] * b[j + 1]
  out[1] = a[i + 2] * b[j] - a[i] * b[j + 2]
  out[2] = a[i] * b[j + 1] - a[i + 1] * b[j]
}

export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

export function length(v: ArrayLike<number>): number {
  return length3(v[0], v[1], v[2])
}

/**
 * Computes the length of a vector with finite coordinates. `Math.hypot` is ten times slower, and its rounding depends on the JavaScript engine.
 * This function returns exactly the same numbers as `Math.hypot` of V8: it scales by the largest coordinate and uses Kahan summation.
 */
export function length3(x: number, y: number, z: number): number {
  const largest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z))
  if (largest === 0) return 0
  const a = x / largest
  const b = y / largest
  const c = z / largest
  const two = a * a + b * b
  const rounding = two - a * a - b * b
  return Math.sqrt(two + (c * c - rounding)) * largest
}

/** Computes the length of a 2D vector as `length3` does. */
export function length2(x: number, y: number): number {
  const largest = Math.max(Math.abs(x), Math.abs(y))
  if (largest === 0) return 0
  const a = x / largest
  const b = y / largest
  return Math.sqrt(a * a + b * b) * largest
}

/** Returns the unit vector in the direction of (x, y), or (0, 0) if both are 0. */
export function unit2(x: number, y: number): [x: number, y: number] {
  const length = length2(x, y) || 1
  return [x / length, y / length]
}

/**
 * Scales a vector to length 1 in place. Leaves the zero vector unchanged.
 *
 * @param offset index of x in `vectors`, for packed arrays of vectors.
 */
export function normalize(vectors: Float64Array | Float32Array, offset = 0): void {
  const scale = length3(vectors[offset], vectors[offset + 1], vectors[offset + 2]) || 1
  for (let k = 0; k < 3; k++) vectors[offset + k] /= scale
}
