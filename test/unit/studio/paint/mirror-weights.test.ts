import { expect, it } from 'vitest'
import { mirrorWeights } from '../../../../studio/src/paint/mirror-weights.ts'
import { cutSheet, empty, onIslands, paint, paintSkin, pointNear } from './skins.ts'

const SIZE = 128

it('each point of the skin gets the weight of its mirror image, also across islands', () => {
  const skin = paintSkin(cutSheet())
  // The dab crosses the seam, on the right.
  const image = paint(empty(SIZE), { radius: 12, softness: 1 }, skin, pointNear(skin, 25, 8, 0))
  const [own, other] = [image, mirrorWeights(image, skin)].map((weights) => onIslands(skin, weights))
  expect(other.some(({ weight, x }) => weight > 200 && x < -20)).toBe(true)
  expect(other.every(({ weight, x }) => weight === 0 || x < -10)).toBe(true)
  // Near the mirror image of each painted point is a point of almost the same weight.
  for (const { x, y, weight } of own.filter(({ weight }) => weight > 0).slice(0, 200)) {
    const near = other.filter((place) => Math.hypot(place.x + x, place.y - y) < 1.5)
    expect(Math.min(...near.map((place) => Math.abs(place.weight - weight)))).toBeLessThan(24)
  }
})

it('the mirror image of an empty map is empty', () => {
  const skin = paintSkin(cutSheet())
  expect(mirrorWeights(empty(SIZE), skin).data.every((weight) => weight === 0)).toBe(true)
})
