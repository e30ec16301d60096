type Numbers = Float32Array | Uint8Array | number[]

/** A step of 8 bits, and a twentieth: graphics cards filter and compute powers with fewer bits than software. */
export const STEP = 1.05 / 255

/**
 * What pictures may differ by, a 400th of a step of 8 bits, whose influence maps are in other cells of the atlas, where coordinates are rounded
 * otherwise; and where nothing wrinkles, since the base is mixed at another length there than the plain face's.
 */
export const ROUNDING = 1e-5

/** Part of the values of two pictures that differ by more than a limit. */
export function shareBeyond(limit: number, a: Numbers, b: Numbers): number {
  let count = 0
  for (let i = 0; i < a.length; i++) if (Math.abs(a[i] - b[i]) > limit) count++
  return count / a.length
}

/** Largest absolute difference of two pictures, over all channels. */
export function largestDifference(a: Numbers, b: Numbers): number {
  let largest = 0
  for (const [i, value] of a.entries()) largest = Math.max(largest, Math.abs(value - b[i]))
  return largest
}
