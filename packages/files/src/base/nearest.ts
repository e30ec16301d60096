import { distance } from 'fastest-levenshtein'

/** Longer names are not typed by hand, and slow to compare. */
const LONGEST = 64

/** Largest part of a name that may be misspelt. */
const MOST_WRONG = 0.4

/** The name that a misspelt one was probably meant to be, whatever its case; undefined where none is near. */
export function nearest(name: string, names: readonly string[]): string | undefined {
  if (name.length > LONGEST) return undefined
  let best: string | undefined
  let least = Math.max(1, Math.floor(MOST_WRONG * name.length)) + 1
  for (const other of names) {
    if (other.length > LONGEST) continue
    const edits = distance(name.toLowerCase(), other.toLowerCase())
    if (edits >= least) continue
    least = edits
    best = other
  }
  return best
}

/** The remedy for an unknown name: the nearest one, or `otherwise` where none is near. */
export function didYouMean(name: string | undefined, names: readonly string[], otherwise: string): string {
  const best = name === undefined ? undefined : nearest(name, names)
  return best === undefined ? otherwise : `did you mean "${best}"?`
}
