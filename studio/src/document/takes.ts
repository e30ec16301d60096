import type { StudioDocument } from './document.ts'
import { checkCount, checkNewName, findNamed, freeName, replaceNamed } from './names.ts'
import { durationOf, MAX_TAKES, TAKE_RATE, type Take } from './take.ts'

/** Adds a take. If its name is taken, appends a number. */
export function addTake(document: StudioDocument, take: Take): StudioDocument {
  const takes = document.takes ?? []
  checkCount(takes, MAX_TAKES, 'take')
  return { ...document, takes: [...takes, { ...take, name: freeName(takes, take.name) }] }
}

export function renameTake(document: StudioDocument, name: string, next: string): StudioDocument {
  if (next === name) return document
  const takes = document.takes ?? []
  checkNewName(takes, next, 'take')
  return { ...document, takes: replaceNamed(takes, name, 'take', (take) => ({ ...take, name: next })) }
}

/** Sets the in and out points. They keep a distance of at least one key frame, and stay within the take. */
export function trimTake(
  document: StudioDocument,
  name: string,
  [start, end]: readonly [number, number],
): StudioDocument {
  const takes = replaceNamed(document.takes ?? [], name, 'take', ({ range: _, ...take }): Take => {
    const duration = durationOf(take.motion)
    const first = Math.min(Math.max(start, 0), duration - 1 / TAKE_RATE)
    const last = Math.min(Math.max(end, first + 1 / TAKE_RATE), duration)
    return first === 0 && last === duration ? take : { ...take, range: [first, last] }
  })
  return { ...document, takes }
}

export function removeTake({ takes = [], ...document }: StudioDocument, name: string): StudioDocument {
  const removed = findNamed(takes, name, 'take')
  const others = takes.filter((take) => take !== removed)
  return { ...document, ...(others.length > 0 && { takes: others }) }
}
