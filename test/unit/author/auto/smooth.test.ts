import { expect, test } from 'vitest'
import { iterationsOf } from '../../../../packages/furrow/src/author/auto/strain/smooth.ts'

/** A square of 200 mm with that many points, smoothed by 5 mm. */
const updates = (points: number) => points * iterationsOf(points, 200 ** 2 / points, 5)

test('smoothing takes no longer per point on a finer mesh, once it is finer than skin creases', () => {
  expect(updates(1_000_000)).toBeLessThanOrEqual(1.1 * updates(250_000))
})

test('a mesh as fine as those of faces is smoothed as far as asked for', () => {
  expect(iterationsOf(13_000, 2 ** 2, 5)).toBe(Math.ceil((2 * 5 * 5) / (0.8 * 2 ** 2)))
})
