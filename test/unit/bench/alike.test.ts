import { expect, it } from 'vitest'
import { alikeness, type FlatPoint } from '../../../bench/auto/identities/alike.ts'
import { seeded } from '../../random.ts'

/** Side of the square in which lines are drawn, millimetres. */
const SIDE = 60
const LINES = 6

/** Returns the points of random straight lines across a square, 0.5 mm apart. Every line has another direction. */
function randomLines(seed: number): FlatPoint[] {
  const random = seeded(seed)
  return Array.from({ length: LINES }, () => {
    const [x, y, angle] = [SIDE * random(), SIDE * random(), 2 * Math.PI * random()]
    return Array.from({ length: 61 }, (_, i): FlatPoint => {
      const along = i / 2 - 15
      return [x + along * Math.cos(angle), y + along * Math.sin(angle)]
    })
  }).flat()
}

const PAIRS = Array.from({ length: 30 }, (_, i) => [randomLines(2 * i + 1), randomLines(2 * i + 2)] as const)

function meanAlikeness(pairs: readonly (readonly [readonly FlatPoint[], readonly FlatPoint[]])[]): number {
  const values = pairs.map(([lines, others]) => alikeness([{ lines, others }])!)
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

it('is 1 for identical patterns, also in parts', () => {
  const [first, second] = PAIRS[0]!
  expect(alikeness([first, second].map((lines) => ({ lines, others: lines })))).toBe(1)
})

it('is about 0 for unrelated patterns', () => {
  expect(Math.abs(meanAlikeness(PAIRS))).toBeLessThan(0.05)
})

it('is about a half if half of the lines are the same', () => {
  const half = (61 * LINES) / 2
  const mixed = PAIRS.map(
    ([lines, others]) => [lines, [...lines.slice(0, half), ...others.slice(half)]] as const,
  )
  expect(meanAlikeness(mixed)).toBeCloseTo(0.5, 1)
})

it('tolerates a shift of 1 mm, but not of 3 mm', () => {
  const shifted = (distance: number) =>
    PAIRS.map(([lines]) => [lines, lines.map(([x, y]): FlatPoint => [x + distance, y])] as const)
  expect(meanAlikeness(shifted(1))).toBeGreaterThan(0.95)
  expect(meanAlikeness(shifted(3))).toBeLessThan(0.4)
})

it('is undefined if a pattern has no lines', () => {
  const [lines] = PAIRS[0]!
  expect(alikeness([{ lines, others: [] }])).toBeUndefined()
  expect(alikeness([{ lines: [], others: lines }])).toBeUndefined()
})
