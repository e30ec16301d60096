/** Largest number of outline pixels that may differ from the reference. A wrong surface exceeds it. */
export const FEW = 50

/** Counts the pixels whose green differs. */
export function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0
  for (let i = 1; i < a.length; i += 4) if (Math.abs(a[i] - b[i]) > 8) count++
  return count
}
