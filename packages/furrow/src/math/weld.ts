/**
 * Numbers the points of a mesh: vertices with the same position at rest share one.
 *
 * @param positions x, y and z of each vertex.
 * @returns the point of each vertex, and how many points there are.
 */
export function weldVertices(positions: ArrayLike<number>): { pointOf: Uint32Array; count: number } {
  const points = new Map<string, number>()
  const pointOf = new Uint32Array(positions.length / 3)
  for (let i = 0; i < pointOf.length; i++) {
    const key = `${positions[3 * i]} ${positions[3 * i + 1]} ${positions[3 * i + 2]}`
    pointOf[i] = points.get(key) ?? points.size
    points.set(key, pointOf[i])
  }
  return { pointOf, count: points.size }
}
