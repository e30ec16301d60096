import type { Anything } from './glb-parts.ts'
import type { Random } from './random.ts'

const NUMBERS = [
  0,
  1,
  -1,
  2,
  3,
  0.5,
  1.5,
  4,
  5,
  7,
  63,
  255,
  256,
  65535,
  65536,
  5120,
  5126,
  1e6,
  1e9,
  2 ** 31 - 1,
  2 ** 31,
  2 ** 32,
  2 ** 53,
  1e20,
  1e308,
  -1e9,
  -1e308,
  1e-308,
]

const JUNK: Anything[] = [
  null,
  true,
  '',
  'brow',
  'x'.repeat(300),
  '漢'.repeat(84),
  'a#b/../c%2f?',
  'CON',
  '../../etc/passwd',
  '\u001b[31mred\u0007',
  'two\nlines',
  '__proto__',
  'MAT4',
  'BYTE',
  [],
  [0, 0],
  [[], {}],
  {},
  { index: 0 },
  { index: -1 },
  { index: 0, slice: 1 },
  { length: 3 },
  { toString: 1, valueOf: null },
]

/** Placeholder for arrays or objects that are nested too deeply for `JSON.stringify`. */
const DEEP = 'furrow-fuzz-deep'
const DEPTHS = [40, 200, 1000, 6000, 50_000]

/** Changes a JSON document once, in place. */
export function damageJson(document: Anything, random: Random): void {
  const nodes = nodesOf(document)
  if (nodes.length === 0) return
  const node = random.pick(nodes)
  const numbers = nodes.filter(({ parent, key }) => typeof parent[key] === 'number')
  const change = random.pick([
    'number',
    'number',
    'number',
    'junk',
    'remove',
    'repeat',
    'swap',
    'rename',
    'deep',
  ])
  if (change === 'number' && numbers.length > 0) {
    const { parent, key } = random.pick(numbers)
    parent[key] = random.chance(0.3) ? parent[key] + random.pick([-1, 1, 2, 4]) : random.pick(NUMBERS)
  } else if (change === 'remove') remove(node)
  else if (change === 'repeat') repeat(nodes, random)
  else if (change === 'swap') {
    const other = random.pick(nodes)
    node.parent[node.key] = structuredClone(other.parent[other.key])
  } else if (change === 'rename') {
    const value = node.parent[node.key]
    remove(node)
    if (!Array.isArray(node.parent))
      node.parent[random.pick(['extras', 'sparse', 'name', `${node.key}s`])] = value
  } else if (change === 'deep')
    node.parent[node.key] = `${DEEP} ${random.pick(DEPTHS)} ${random.pick(['[', '{'])}`
  else node.parent[node.key] = structuredClone(random.pick(JUNK))
}

/** Serialises a document, and expands the placeholders that `damageJson` inserted. */
export function textOf(document: Anything): string {
  return JSON.stringify(document).replace(/"furrow-fuzz-deep (\d+) (.)"/g, (_, depth, open) => {
    return open === '['
      ? '['.repeat(depth) + ']'.repeat(depth)
      : `${'{"a":'.repeat(depth)}1${'}'.repeat(depth)}`
  })
}

interface JsonNode {
  parent: Anything
  key: string
}

/** Lists all values in a document. */
function nodesOf(value: Anything, nodes: JsonNode[] = []): JsonNode[] {
  if (typeof value !== 'object' || value === null) return nodes
  for (const key of Object.keys(value)) {
    nodes.push({ parent: value, key })
    nodesOf(value[key], nodes)
  }
  return nodes
}

function remove({ parent, key }: JsonNode): void {
  if (Array.isArray(parent)) parent.splice(Number(key), 1)
  else delete parent[key]
}

/** Lengthens a list by repeating one of its items. */
function repeat(nodes: readonly JsonNode[], random: Random): void {
  const lists = nodes.flatMap(({ parent, key }) =>
    Array.isArray(parent[key]) ? [parent[key] as Anything[]] : [],
  )
  const filled = lists.filter((items) => items.length > 0)
  if (filled.length === 0) return
  const list = random.pick(filled)
  const item = random.pick(list)
  const times = random.pick([1, 3, 20, 300, 5000])
  for (let i = 0; i < times; i++) list.push(structuredClone(item))
}
