type Numbers = Float32Array | Uint8Array | number[]

/** Tolerance of one 8-bit step. 5% are added, because GPUs filter and compute powers less precisely than software. */
export const STEP = 1.05 / 255

/**
 * Tolerance for pictures that differ only by rounding: a 400th of an 8-bit step. Coordinates round differently in
 * another cell of the influence atlas, and the base normal of pixels without influence may have another length.
 */
export const ROUNDING = 1e-5

/** Returns the fraction of values that differ by more than a limit. */
export function shareBeyond(limit: number, a: Numbers, b: Numbers): number {
  let count = 0
  for (let i = 0; i < a.length; i++) if (Math.abs(a[i] - b[i]) > limit) count++
  return count / a.length
}

/** Returns the largest absolute difference of two pictures over all channels. */
export function largestDifference(a: Numbers, b: Numbers): number {
  let largest = 0
  for (const [i, value] of a.entries()) largest = Math.max(largest, Math.abs(value - b[i]))
  return largest
}
