import fc from 'fast-check'
import { inject } from 'vitest'

/** Number of mutated documents to test. */
export const MUTATED: number = inject('inDepth') ? 100_000 : 10_000

// biome-ignore lint/suspicious/noExplicitAny: invalid on purpose
type Anything = any

/** Values that a hostile or broken program might write anywhere. */
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

/** Value in a JSON document, by its parent and key. The root has no parent. */
interface JsonNode {
  parent?: Anything
  key: string
}

/** Lists all values of a JSON document, parents first. */
function nodesOf(value: Anything, nodes: JsonNode[] = [{ key: '' }]): JsonNode[] {
  if (typeof value !== 'object' || value === null) return nodes
  for (const key of Object.keys(value)) {
    nodes.push({ parent: value, key })
    nodesOf(value[key], nodes)
  }
  return nodes
}

interface Mutation {
  node: number
  action: 'replace' | 'remove' | 'double' | 'swap' | 'nest' | 'rename'
  junk: Anything
}

/** Changes one value of a document. The JSON stays valid. */
export function mutate(document: Anything, { node, action, junk }: Mutation): Anything {
  const nodes = nodesOf(document)
  const { parent, key }: { parent?: Anything; key: Anything } = nodes[node % nodes.length]
  if (!parent) return action === 'nest' ? [document] : structuredClone(junk)
  if (action === 'replace') parent[key] = structuredClone(junk)
  else if (action === 'nest') parent[key] = { index: parent[key] }
  else if (Array.isArray(parent)) {
    if (action === 'remove') parent.splice(key, 1)
    else if (action === 'double') parent.push(structuredClone(parent[key]))
    else parent.reverse()
  } else {
    if (action === 'remove' || action === 'rename') delete parent[key]
    if (action === 'rename') parent[`${key}s`] = structuredClone(junk)
    if (action === 'swap') parent[key] = structuredClone(Object.values(parent)[0])
  }
  return document
}

export const mutation = fc.record<Mutation>({
  node: fc.nat(400),
  action: fc.constantFrom('replace', 'remove', 'double', 'swap', 'nest', 'rename'),
  junk: fc.oneof(
    { weight: 4, arbitrary: fc.constantFrom(...JUNK) },
    { weight: 1, arbitrary: fc.jsonValue({ maxDepth: 2 }) },
  ),
})

/**
 * Compares a schema with a parser on many mutated documents. Expects that the schema accepts everything that the parser accepts.
 *
 * @param parse throws for invalid documents.
 * @returns `accepted`: number of documents that the parser accepted. `missed`: fraction of refused documents that the schema accepted.
 */
export function compareWithParser(
  document: Anything,
  validate: (document: unknown) => boolean,
  parse: (document: Anything) => unknown,
  seed: number,
): { accepted: number; missed: number } {
  const text = JSON.stringify(document)
  let [accepted, refused, missed] = [0, 0, 0]
  fc.assert(
    fc.property(fc.array(mutation, { minLength: 1, maxLength: 2 }), (mutations) => {
      const mutated = mutations.reduce(mutate, JSON.parse(text))
      const passes = validate(mutated)
      try {
        parse(mutated)
      } catch {
        refused++
        if (passes) missed++
        return true
      }
      accepted++
      return passes
    }),
    { numRuns: MUTATED / 10, seed },
  )
  return { accepted, missed: missed / refused }
}
