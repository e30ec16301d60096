/** A list as a worker that has the last one can rebuild it: indices of what it has, and new items. */
export type ListChanges<T> = (number | T)[]

/** What turns one list into another, by identity: objects lose theirs on the way to a worker. */
export function changesOf<T extends object>(before: readonly T[], after: readonly T[]): ListChanges<T> {
  const indices = new Map(before.map((item, i) => [item, i]))
  return after.map((item) => indices.get(item) ?? item)
}

/** The list after some changes; items that stay are the same objects. */
export function applyChanges<T extends object>(before: readonly T[], changes: ListChanges<T>): T[] {
  return changes.map((change) => (typeof change === 'number' ? before[change] : change))
}
