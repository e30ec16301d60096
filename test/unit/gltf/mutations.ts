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

type Path = (string | number)[]

/** Every place of a JSON document, from the root down. */
function placesOf(value: Anything, path: Path = []): Path[] {
  if (typeof value !== 'object' || value === null) return [path]
  return [path, ...Object.keys(value).flatMap((key) => placesOf(value[key], [...path, key]))]
}

interface Mutation {
  place: number
  deed: 'replace' | 'remove' | 'double' | 'swap' | 'nest' | 'rename'
  junk: Anything
}

/** One small change at one place; a document stays JSON whatever is done to it. */
export function mutate(document: Anything, { place, deed, junk }: Mutation): Anything {
  const places = placesOf(document)
  const path = places[place % places.length]
  if (path.length === 0) return deed === 'nest' ? [document] : structuredClone(junk)
  const parent = path.slice(0, -1).reduce((at: Anything, key) => at[key], document)
  const key = path.at(-1) as Anything
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
