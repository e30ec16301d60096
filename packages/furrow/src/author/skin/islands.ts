/** Returns, for each vertex, a representative vertex of its connected component (union-find with path halving). */
export function islandsOf(indices: ArrayLike<number>, count: number): Uint32Array {
  const parents = Uint32Array.from({ length: count }, (_, i) => i)
  const rootOf = (vertex: number) => {
    let node = vertex
    while (parents[node] !== node) {
      parents[node] = parents[parents[node]]
      node = parents[node]
    }
    return node
  }
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const first = rootOf(indices[t])
    for (let k = 1; k < 3; k++) parents[rootOf(indices[t + k])] = first
  }
  return parents.map((_, vertex) => rootOf(vertex))
}
