/** Smallest fraction of pixels that wrinkles must change: a variant that shows none would be fast. */
export const MIN_CHANGED = 0.005

/** Fraction of the pixels of two pictures, RGBA bytes, that differ. */
export function changedFraction(a: Uint8Array, b: Uint8Array): number {
  let changed = 0
  for (let i = 0; i < a.length; i += 4) {
    if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) changed++
  }
  return changed / (a.length / 4)
}
