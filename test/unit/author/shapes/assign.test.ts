import { expect, test } from 'vitest'
import { assign } from '../../../../packages/furrow/src/author/shapes/matching/assign.ts'
import { seeded } from '../../../random.ts'

/** Returns the smallest total cost of assigning a different column to each row. Tries all assignments. */
function minCost(cost: readonly Float64Array[], row = 0, taken = new Set<number>()): number {
  if (row === cost.length) return 0
  let least = Number.POSITIVE_INFINITY
  for (const [column, value] of cost[row]!.entries()) {
    if (!taken.has(column))
      least = Math.min(least, value + minCost(cost, row + 1, new Set([...taken, column])))
  }
  return least
}

test.each([
  [1, 1],
  [1, 4],
  [3, 3],
  [4, 6],
  [5, 5],
])('%i rows get the cheapest of %i columns', (rows, columns) => {
  const random = seeded(10 * rows + columns)
  for (const isStepped of [false, true]) {
    for (let n = 0; n < 40; n++) {
      const cost = Array.from({ length: rows }, () =>
        Float64Array.from({ length: columns }, () => (isStepped ? Math.floor(4 * random()) : random()) - 1),
      )
      const assigned = assign(cost)
      expect(new Set(assigned).size).toBe(rows)
      const total = assigned.reduce((sum, column, row) => sum + cost[row]![column]!, 0)
      expect(total).toBeCloseTo(minCost(cost), 12)
    }
  }
})

test('the assignment of no rows is empty', () => {
  expect(assign([])).toEqual([])
})
