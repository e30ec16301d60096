import { expect, it } from 'vitest'
import { mirrorWeights } from '../../../../studio/src/paint/mirror-weights.ts'
import { cutSheet, empty, onIslands, paint, paintSkin, pointNear } from './skins.ts'

const SIZE = 128

it('each place has the weight of its mirror image, across islands', () => {
  const skin = paintSkin(cutSheet())
  // Across the seam, on the right.
  const image = paint(empty(SIZE), { radius: 12, softness: 1 }, skin, pointNear(skin, 25, 8, 0))
  const [own, other] = [image, mirrorWeights(image, skin)].map((weights) => onIslands(skin, weights))
  expect(other.some(({ weight, x }) => weight > 200 && x < -20)).toBe(true)
  expect(other.every(({ weight, x }) => weight === 0 || x < -10)).toBe(true)
  // At each place of the image, its mirror image is a texel or two away.
  for (const { x, y, weight } of own.filter(({ weight }) => weight > 0).slice(0, 200)) {
    const near = other.filter((place) => Math.hypot(place.x + x, place.y - y) < 1.5)
    expect(Math.min(...near.map((place) => Math.abs(place.weight - weight)))).toBeLessThan(24)
  }
})

it('the mirror image of an empty map is empty', () => {
  const skin = paintSkin(cutSheet())
  expect(mirrorWeights(empty(SIZE), skin).data.every((weight) => weight === 0)).toBe(true)
})
