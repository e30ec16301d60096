import { FurrowError } from 'furrow'
import { isName, MAX_NAME_LENGTH } from 'furrow/internal'

/** Item whose name is unique in its list. */
interface Named {
  readonly name: string
}

/** Finds an item by name. Throws FurrowError if the name is unknown. */
export function findNamed<T extends Named>(items: readonly T[], name: string, kind: string): T {
  const item = items.find((each) => each.name === name)
  if (item) return item
  throw new FurrowError({
    code: 'unknown-name',
    who: 'Studio',
    problem: `no such ${kind}`,
    value: name,
    limit: items.map((each) => each.name).join(', ') || 'none',
    remedy: items.length > 0 ? 'name one of these' : 'add one first',
  })
}

/** Maps items. Returns the same array if no item changes. */
export function changed<T>(items: readonly T[], change: (item: T) => T): readonly T[] {
  const others = items.map(change)
  return others.every((item, i) => item === items[i]) ? items : others
}

/** Filters items. Returns the same array if all pass. */
export function kept<T>(items: readonly T[], test: (item: T) => boolean): readonly T[] {
  return items.every(test) ? items : items.filter(test)
}

/** Applies `change` to the item with this name. Returns all items. Throws FurrowError if the name is unknown. */
export function replaceNamed<T extends Named>(
  items: readonly T[],
  name: string,
  kind: string,
  change: (item: T) => T,
): T[] {
  const old = findNamed(items, name, kind)
  return items.map((item) => (item === old ? change(item) : item))
}

/** Throws FurrowError if the maximum number of items is reached. */
export function checkCount(items: readonly Named[], most: number, kind: string): void {
  if (items.length < most) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `too many ${kind}s`,
    value: most + 1,
    limit: `${most}`,
    remedy: 'remove one first',
  })
}

/** Throws FurrowError if a name is invalid or taken. */
export function checkNewName(items: readonly Named[], name: string, kind: string): void {
  if (!isName(name)) {
    throw new FurrowError({
      who: 'Studio',
      problem: `the ${kind} has no usable name`,
      value: name,
      limit: '1 to 256 characters on one line',
      remedy: 'choose another name',
    })
  }
  if (!items.some((item) => item.name === name)) return
  throw new FurrowError({
    who: 'Studio',
    problem: `another ${kind} already has this name`,
    value: name,
    remedy: 'choose another name',
  })
}

/** Returns `name` if no item has this name. Otherwise returns the first free name among `name 2`, `name 3`... */
export function freeName(items: readonly Named[], name: string): string {
  const isTaken = (candidate: string) => items.some((item) => item.name === candidate)
  if (!isTaken(name)) return name
  const stem = name.replace(/ \d+$/, '')
  for (let i = 2; ; i++) {
    const candidate = appendNumber(stem, i)
    if (!isTaken(candidate)) return candidate
  }
}

/** Appends a number to a name. Shortens the name if the result would be too long. */
function appendNumber(stem: string, number: number): string {
  const end = ` ${number}`
  return [...stem].slice(0, MAX_NAME_LENGTH - end.length).join('') + end
}
