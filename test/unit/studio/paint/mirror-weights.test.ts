import { expect, it } from 'vitest'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import { mirrorWeights } from '../../../../studio/src/paint/mirror-weights.ts'
import { cutSheet, empty, paintSkin, placesOf, pointNear } from './skins.ts'

const SIZE = 128

it('each place has the weight of its mirror image, in whichever island either is', () => {
  const skin = paintSkin(cutSheet())
  const stroke = new BrushStroke(empty(SIZE), { ...BRUSH_DEFAULTS, radius: 12, softness: 1, flow: 1 }, skin)
  // Across the seam, on the right.
  stroke.moveTo(pointNear(skin, 25, 8, 0))
  const { image } = stroke.end()
  const mirrored = mirrorWeights(image, skin)
  const weights = (of: typeof image) =>
    [...placesOf(skin.mapOf(SIZE), of)].filter(({ isBeyond }) => !isBeyond)
  const [own, other] = [weights(image), weights(mirrored)]
  expect(other.some(({ weight, x }) => weight > 200 && x < -20)).toBe(true)
  expect(other.every(({ weight, x }) => weight === 0 || x < -10)).toBe(true)
  // At each place of the image, that of the mirror image is a texel or two away.
  for (const { x, y, weight } of own.filter(({ weight }) => weight > 0).slice(0, 200)) {
    const near = other.filter((place) => Math.hypot(place.x + x, place.y - y) < 1.5)
    expect(Math.min(...near.map((place) => Math.abs(place.weight - weight)))).toBeLessThan(24)
  }
})

it('the mirror image of nothing is nothing', () => {
  const skin = paintSkin(cutSheet())
  expect(mirrorWeights(empty(SIZE), skin).data.every((weight) => weight === 0)).toBe(true)
})
