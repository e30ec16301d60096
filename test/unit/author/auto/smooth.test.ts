import { expect, test } from 'vitest'
import { iterationsOf } from '../../../../packages/furrow/src/author/auto/strain/smooth.ts'

/** Returns the number of point updates if a surface of 200 x 200 mm is smoothed by 5 mm. Each point has six neighbours. */
const updates = (points: number, runs = 1) =>
  runs * points * iterationsOf(6 * points, 200 ** 2 / points, 5, runs)

test('smoothing takes no longer per point on a mesh that is finer than wrinkles', () => {
  expect(updates(1_000_000)).toBeLessThanOrEqual(1.1 * updates(250_000))
})

test('a mesh as fine as a usual face is smoothed by the full distance', () => {
  expect(iterationsOf(6 * 13_000, 2 ** 2, 5, 60)).toBe(Math.ceil((2 * 5 * 5) / (0.8 * 2 ** 2)))
})

test('thousands of blendshapes are smoothed as fast as dozens', () => {
  expect(updates(250_000, 3000)).toBeLessThanOrEqual(2 * updates(250_000, 30))
})

test('a mesh in which all points are neighbours is smoothed in fewer steps', () => {
  const points = 2000
  const reads = points ** 2 * iterationsOf(points ** 2, 0.01, 5)
  expect(reads).toBeLessThanOrEqual(1.1 * 6 * updates(250_000))
})
