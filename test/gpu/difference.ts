type Numbers = Float32Array | Uint8Array | number[]

/** Largest absolute difference of two pictures, over all channels. */
export function largestDifference(a: Numbers, b: Numbers): number {
  let largest = 0
  for (const [i, value] of a.entries()) largest = Math.max(largest, Math.abs(value - b[i]))
  return largest
}
