type Numbers = Float32Array | Uint8Array | number[]

/** One 8-bit step plus a twentieth, because GPUs filter and compute powers with less precision than software. */
export const STEP = 1.05 / 255

/**
 * Tolerance for pictures that differ only by rounding: a 400th of an 8-bit step. Coordinates round differently in other
 * atlas cells, and unwrinkled pixels mix a base normal of another length than the plain face's.
 */
export const ROUNDING = 1e-5

/** Returns the share of values that differ by more than a limit. */
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
