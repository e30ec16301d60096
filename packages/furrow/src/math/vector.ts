/**
 * Computes the cross product of `a` and `b`. `out` must be another array than both.
 *
 * @param i, j indices of the vectors' x in `a` and `b`, for packed arrays.
 */
export function cross(out: Float64Array, a: ArrayLike<number>, b: ArrayLike<number>, i = 0, j = 0): void {
  out[0] = a[i + 1] * b[j + 2] - a[i + 2] * b[j + 1]
  out[1] = a[i + 2] * b[j] - a[i] * b[j + 2]
  out[2] = a[i] * b[j + 1] - a[i + 1] * b[j]
}

/** Computes the dot product. */
export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

export function length(v: ArrayLike<number>): number {
  return length3(v[0], v[1], v[2])
}

/**
 * Computes the length of a vector with finite coordinates. Matches `Math.hypot` of V8 bit by bit: scales by the largest coordinate, with
 * Kahan summation. The built-in is ten times slower, and its rounding depends on the engine.
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

/** `length3` for two coordinates. */
export function length2(x: number, y: number): number {
  const largest = Math.max(Math.abs(x), Math.abs(y))
  if (largest === 0) return 0
  const a = x / largest
  const b = y / largest
  return Math.sqrt(a * a + b * b) * largest
}

/**
 * Scales a vector to length 1 in place. Leaves the zero vector unchanged.
 *
 * @param offset index of the vector's x in `vectors`, for packed arrays.
 */
export function normalize(vectors: Float64Array | Float32Array, offset = 0): void {
  const scale = length3(vectors[offset], vectors[offset + 1], vectors[offset + 2]) || 1
  for (let k = 0; k < 3; k++) vectors[offset + k] /= scale
}
