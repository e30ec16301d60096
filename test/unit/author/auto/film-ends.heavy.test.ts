import { expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { FACES, facialCreases, prepareFace } from './faces.ts'

test.each(FACES)("%s: crow's feet start at the eye and end at the temple", async (_, path) => {
  const regions = facialCreases(prepareFace(await skinAt(path)), 0.7)
  const crowsFeet = regions.filter(({ region }) => region.name.startsWith('crowsFeet'))
  const folds = crowsFeet.flatMap(({ folds }) => folds)
  expect(folds.length).toBeGreaterThan(6)
  for (const { points } of folds)
    expect(Math.abs(points[0])).toBeLessThan(Math.abs(points[points.length - 3]))
})
