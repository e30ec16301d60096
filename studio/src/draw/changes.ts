/** List relative to a previous one: indices of kept items, and new items. */
export type ListChanges<T> = (number | T)[]

/** Computes the changes between two lists of objects, compared by identity. A worker receives copies, so it cannot compare them itself. */
export function changesOf<T extends object>(before: readonly T[], after: readonly T[]): ListChanges<T> {
  const indices = new Map(before.map((item, i) => [item, i]))
  return after.map((item) => indices.get(item) ?? item)
}

/** Applies changes to a list. Kept items are the same objects. */
export function applyChanges<T extends object>(before: readonly T[], changes: ListChanges<T>): T[] {
  return changes.map((change) => (typeof change === 'number' ? before[change] : change))
}
