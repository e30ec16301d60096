import fc from 'fast-check'

// biome-ignore lint/suspicious/noExplicitAny: broken on purpose, everywhere
type Anything = any

/** What a hostile or broken writer may put in any place. */
const JUNK: Anything[] = [
  null,
  true,
  0,
  -1,
  1.5,
  4,
  1e300,
  '',
  'brow',
  'x'.repeat(300),
  [],
  [0, 0],
  [[], {}],
  {},
  { index: 0 },
  { index: -1 },
  { index: 0, slice: 1 },
  { index: 0, slice: -1 },
  { type: 'morph' },
  { name: 'nose' },
  { length: 3 },
  { toString: 1, valueOf: null },
]

/** A place of a JSON document: what holds it, and under which key; the root is held by nothing. */
interface Place {
  parent?: Anything
  key: string
}

/** Every place of a JSON document, from the root down. */
function placesOf(value: Anything, places: Place[] = [{ key: '' }]): Place[] {
  if (typeof value !== 'object' || value === null) return places
  for (const key of Object.keys(value)) {
    places.push({ parent: value, key })
    placesOf(value[key], places)
  }
  return places
}

interface Mutation {
  place: number
  deed: 'replace' | 'remove' | 'double' | 'swap' | 'nest' | 'rename'
  junk: Anything
}

/** One small change at one place; a document stays JSON whatever is done to it. */
export function mutate(document: Anything, { place, deed, junk }: Mutation): Anything {
  const places = placesOf(document)
  const { parent, key }: { parent?: Anything; key: Anything } = places[place % places.length]
  if (!parent) return deed === 'nest' ? [document] : structuredClone(junk)
  if (deed === 'replace') parent[key] = structuredClone(junk)
  else if (deed === 'nest') parent[key] = { index: parent[key] }
  else if (Array.isArray(parent)) {
    if (deed === 'remove') parent.splice(key, 1)
    else if (deed === 'double') parent.push(structuredClone(parent[key]))
    else parent.reverse()
  } else {
    if (deed === 'remove' || deed === 'rename') delete parent[key]
    if (deed === 'rename') parent[`${key}s`] = structuredClone(junk)
    if (deed === 'swap') parent[key] = structuredClone(Object.values(parent)[0])
  }
  return document
}

export const mutation = fc.record<Mutation>({
  place: fc.nat(400),
  deed: fc.constantFrom('replace', 'remove', 'double', 'swap', 'nest', 'rename'),
  junk: fc.oneof(
    { weight: 4, arbitrary: fc.constantFrom(...JUNK) },
    { weight: 1, arbitrary: fc.jsonValue({ maxDepth: 2 }) },
  ),
})
