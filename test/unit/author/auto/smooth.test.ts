import { expect, test } from 'vitest'
import { iterationsOf } from '../../../../packages/furrow/src/author/auto/strain/smooth.ts'

/** Smooths a square of 200 mm with `points` points of six neighbours by 5 mm. */
const updates = (points: number, runs = 1) =>
  runs * points * iterationsOf(6 * points, 200 ** 2 / points, 5, runs)

test('smoothing takes no longer per point on a mesh finer than skin creases', () => {
  expect(updates(1_000_000)).toBeLessThanOrEqual(1.1 * updates(250_000))
})

test("a mesh as fine as a face's is smoothed as far as requested", () => {
  expect(iterationsOf(6 * 13_000, 2 ** 2, 5, 60)).toBe(Math.ceil((2 * 5 * 5) / (0.8 * 2 ** 2)))
})

test('thousands of blendshapes are smoothed as fast as dozens', () => {
  expect(updates(250_000, 3000)).toBeLessThanOrEqual(2 * updates(250_000, 30))
})

test('points that are all neighbours are smoothed less often', () => {
  const points = 2000
  const reads = points ** 2 * iterationsOf(points ** 2, 0.01, 5)
  expect(reads).toBeLessThanOrEqual(1.1 * 6 * updates(250_000))
})
