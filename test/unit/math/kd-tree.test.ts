import { expect, test } from 'vitest'
import { KdTree } from '../../../packages/furrow/src/math/kd-tree.ts'
import { seeded } from '../../random.ts'

/** Returns random coordinates. If stepped, they are multiples of 0.1, so that some points and distances are equal. */
function coordinates(random: () => number, count: number, isStepped: boolean): number[] {
  return Array.from({ length: count }, () => (isStepped ? Math.round(10 * random()) / 10 : random()))
}

/** Returns the squared distance from `query` to each point. */
function squaresTo(points: readonly number[], dimensions: number, query: readonly number[]): number[] {
  return Array.from({ length: points.length / dimensions }, (_, i) =>
    query.reduce((sum, x, d) => sum + (points[i * dimensions + d]! - x) ** 2, 0),
  )
}

test.each([
  [2, 0],
  [2, 1],
  [3, 7],
  [2, 200],
  [3, 500],
])('%i dimensions and %i points: a tree finds the same points as a linear search', (dimensions, count) => {
  const random = seeded(100 * dimensions + count)
  for (const isStepped of [false, true]) {
    const points = coordinates(random, dimensions * count, isStepped)
    const tree = new KdTree(points, dimensions, 6)
    for (let n = 0; n < 60; n++) {
      const query = coordinates(random, dimensions, isStepped)
      const limit = n % 3 === 0 ? Number.POSITIVE_INFINITY : 0.4 * random()
      const squares = squaresTo(points, dimensions, query)
      const within = [...squares.keys()].filter((i) => squares[i]! <= limit ** 2)

      const found = tree.nearest([9, ...query], 1, limit)
      const indices = [...found.indices.subarray(0, found.count)]
      const nearest = within.map((i) => squares[i]!).sort((a, b) => a - b)
      expect([...found.squares.subarray(0, found.count)]).toEqual(nearest.slice(0, 6))
      expect(indices.map((i) => squares[i])).toEqual(nearest.slice(0, 6))
      expect(new Set(indices).size).toBe(indices.length)

      const visited: number[] = []
      tree.within([9, ...query], 1, limit, (index) => visited.push(index))
      expect(visited.sort((a, b) => a - b)).toEqual(within)
    }
  }
})
