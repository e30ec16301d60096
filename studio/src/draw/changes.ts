/** List relative to a previous list. Numbers are indices in the previous list; other entries are new items. */
export type ListChanges<T> = (number | T)[]

/** Encodes `after` relative to `before`. A worker receives copies of items, so it cannot find unchanged items by identity. */
export function changesOf<T extends object>(before: readonly T[], after: readonly T[]): ListChanges<T> {
  const indices = new Map(before.map((item, i) => [item, i]))
  return after.map((item) => indices.get(item) ?? item)
}

/** Decodes a list that is relative to `before`. */
export function applyChanges<T extends object>(before: readonly T[], changes: ListChanges<T>): T[] {
  return changes.map((change) => (typeof change === 'number' ? before[change] : change))
}
