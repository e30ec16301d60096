/** Minimum fraction of pixels that wrinkles must change. A variant that fails to show wrinkles would be fast, but not comparable. */
export const MIN_CHANGED = 0.005

/** Returns the fraction of pixels whose colour differs between two RGBA pictures, 0..1. */
export function changedFraction(a: Uint8Array, b: Uint8Array): number {
  let changed = 0
  for (let i = 0; i < a.length; i += 4) {
    if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) changed++
  }
  return changed / (a.length / 4)
}
