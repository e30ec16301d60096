/** a x b. `out` must be neither of them. */
export function cross(out: Float64Array, a: ArrayLike<number>, b: ArrayLike<number>): void {
  out[0] = a[1] * b[2] - a[2] * b[1]
  out[1] = a[2] * b[0] - a[0] * b[2]
  out[2] = a[0] * b[1] - a[1] * b[0]
}

/** a . b */
export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

export function length(v: ArrayLike<number>): number {
  return Math.hypot(v[0], v[1], v[2])
}

/**
 * Scales a vector to length 1 in place. The zero vector stays as it is.
 *
 * @param offset of its x, for a vector in an array of many.
 */
export function normalize(vectors: Float64Array | Float32Array, offset = 0): void {
  const scale = Math.hypot(vectors[offset], vectors[offset + 1], vectors[offset + 2]) || 1
  for (let k = 0; k < 3; k++) vectors[offset + k] /= scale
}
