import { FurrowError } from './error.ts'

/** Maximum length of compared names. Longer names are rarely typed by hand, and comparing them is slow. */
const MAX_LENGTH = 64

/** Maximum fraction of a name's characters that may be misspelt. */
const MAX_MISSPELT = 0.4

/** Returns the most similar name, ignoring case, or undefined if none is similar enough. */
export function nearestName(name: string, names: readonly string[]): string | undefined {
  if (name.length > MAX_LENGTH) return undefined
  let best: string | undefined
  let least = Math.max(1, Math.floor(MAX_MISSPELT * name.length)) + 1
  for (const other of names) {
    if (other.length > MAX_LENGTH) continue
    const edits = editDistance(name.toLowerCase(), other.toLowerCase())
    if (edits >= least) continue
    least = edits
    best = other
  }
  return best
}

/** Returns the remedy for an unknown name: a suggestion of the most similar name, or `fallback` if no name is similar enough. */
export function didYouMean(name: unknown, names: readonly string[], fallback: string): string {
  const best = typeof name === 'string' ? nearestName(name, names) : undefined
  return best === undefined ? fallback : `did you mean "${best}"?`
}

/**
 * Checks that all keys of `options` are known.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError for the first unknown name.
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
    remedy: didYouMean(unknown, known, 'correct the name or remove the option'),
  })
}

/** Computes the Levenshtein distance. Only one row of the distance table is kept. */
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
