import type { Sculpted, SculptedTile } from '../document/sculpted.ts'

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

/** Sculpted heights relative to those of the last call. */
export interface SculptedChanges {
  /** Width and height of the sculpted heights, texels. */
  readonly size: number
  /** Changed tiles by their index. Undefined: the tile is flat now. */
  readonly tiles: ReadonlyMap<number, SculptedTile | undefined>
}

/** Encodes sculpted heights relative to `before`. Returns null if nothing has changed. */
export function sculptedChanges(before: Sculpted | null, after: Sculpted | null): SculptedChanges | null {
  if (before === after) return null
  const size = after?.size ?? before!.size
  const old: Sculpted['tiles'] = before?.size === size ? before.tiles : new Map()
  const next: Sculpted['tiles'] = after?.tiles ?? new Map()
  const changed = [...old.keys(), ...next.keys()].filter((index) => old.get(index) !== next.get(index))
  return { size, tiles: new Map(changed.map((index) => [index, next.get(index)])) }
}
