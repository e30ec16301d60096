import { FurrowError } from './error.ts'

/** Longer names are not typed by hand, and slow to compare. */
const LONGEST = 64

/** Largest part of a name that may be misspelt. */
const MOST_WRONG = 0.4

/** The name that a misspelt one was probably meant to be, whatever its case; undefined where none is near. */
export function nearestName(name: string, names: readonly string[]): string | undefined {
  if (name.length > LONGEST) return undefined
  let best: string | undefined
  let least = Math.max(1, Math.floor(MOST_WRONG * name.length)) + 1
  for (const other of names) {
    if (other.length > LONGEST) continue
    const edits = editDistance(name.toLowerCase(), other.toLowerCase())
    if (edits >= least) continue
    least = edits
    best = other
  }
  return best
}

/** The remedy for an unknown name: the nearest one, or `otherwise` where none is near. */
export function didYouMean(name: unknown, names: readonly string[], otherwise: string): string {
  const best = typeof name === 'string' ? nearestName(name, names) : undefined
  return best === undefined ? otherwise : `did you mean "${best}"?`
}

/**
 * Checks the names of options.
 *
 * @param who the caller, in errors.
 * @throws FurrowError at the first name that is not known.
 */
export function checkOptionNames(options: object, known: readonly string[], who: string): void {
  const unknown = Object.keys(options).find((name) => !known.includes(name))
  if (unknown === undefined) return
  throw new FurrowError({
    code: 'unknown-name',
    who,
    problem: 'unknown option',
    value: unknown,
    limit: known.join(', '),
    remedy: didYouMean(unknown, known, 'correct the name or leave it out'),
  })
}

/** Levenshtein's distance: single characters to insert, delete or replace. Keeps one row of the usual table. */
function editDistance(a: string, b: string): number {
  const row = Array.from({ length: b.length + 1 }, (_, j) => j)
  for (let i = 1; i <= a.length; i++) {
    let diagonal = row[0]
    row[0] = i
    for (let j = 1; j <= b.length; j++) {
      const above = row[j]
      const replaced = diagonal + (a[i - 1] === b[j - 1] ? 0 : 1)
      row[j] = Math.min(replaced, above + 1, row[j - 1] + 1)
      diagonal = above
    }
  }
  return row[b.length]
}
