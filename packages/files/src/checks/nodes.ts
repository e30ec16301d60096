import type { CheckedJson } from '../json/checked-json.ts'

/** Maximum depth of a node hierarchy, because some readers recurse. Skeletons are tens of nodes deep. */
const MAX_DEPTH = 256

/**
 * Checks that nodes form trees (glTF 2.0, 3.5.2) at most 256 deep. Ignores references to missing children.
 *
 * @returns error text, or undefined.
 */
export function nodeProblem({ nodes = [] }: CheckedJson): string | undefined {
  const parents = new Int32Array(nodes.length).fill(-1)
  const childrenOf = (i: number) => (nodes[i].children ?? []).filter((child) => child < nodes.length)
  for (const i of nodes.keys()) {
    for (const child of childrenOf(i)) {
      if (parents[child] >= 0) return `nodes[${child}] has two parents, ${parents[child]} and ${i}`
      parents[child] = i
    }
  }
  // Walks from the roots down. Nodes in a cycle are never reached.
  let level = [...nodes.keys()].filter((i) => parents[i] < 0)
  let reached = 0
  for (let depth = 1; level.length > 0; depth++) {
    if (depth > MAX_DEPTH) return `nodes[${level[0]}] has more than ${MAX_DEPTH} ancestors`
    reached += level.length
    level = level.flatMap(childrenOf)
  }
  return reached === nodes.length ? undefined : 'some of its nodes are their own ancestors'
}
