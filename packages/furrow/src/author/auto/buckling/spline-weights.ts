/** Computes the weights of four coefficients of a uniform cubic B-spline at t, 0..1, between the middle two. */
export function splineWeights(out: Float64Array, t: number): void {
  const s = 1 - t
  out[0] = (s * s * s) / 6
  out[1] = (4 - 6 * t * t + 3 * t * t * t) / 6
  out[2] = (4 - 6 * s * s + 3 * s * s * s) / 6
  out[3] = (t * t * t) / 6
}

/** Computes the first derivatives of `splineWeights`. */
export function splineSlopes(out: Float64Array, t: number): void {
  const s = 1 - t
  out[0] = (-s * s) / 2
  out[1] = (3 * t * t - 4 * t) / 2
  out[2] = (4 * s - 3 * s * s) / 2
  out[3] = (t * t) / 2
}

/** Computes the second derivatives of `splineWeights`. */
export function splineCurvatures(out: Float64Array, t: number): void {
  out[0] = 1 - t
  out[1] = 3 * t - 2
  out[2] = 1 - 3 * t
  out[3] = t
}
