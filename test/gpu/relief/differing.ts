/** Pixels of outlines in which a surface that is as fine as the picture may differ from the reference, and one that is wrong does not. */
export const FEW = 50

/** Number of pixels whose green differs. */
export function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0
  for (let i = 1; i < a.length; i += 4) if (Math.abs(a[i] - b[i]) > 8) count++
  return count
}
