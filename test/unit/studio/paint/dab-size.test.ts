import type { GrayImage } from 'furrow'
import { expect, it } from 'vitest'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { visibleRadius } from '../../../../studio/src/paint/dab-size.ts'
import { empty, paint, paintSkin, plainSheet, pointNear } from './skins.ts'

const SIZE = 32
/** Width of a texel of the sheet, millimetres. */
const TEXEL = 100 / SIZE
const DIRECTIONS = Array.from({ length: 16 }, (_, i) => (Math.PI * i) / 8)
/** Positions of dabs between the centres of texels, millimetres. */
const PLACES = [-0.5, -0.25, 0, 0.25].flatMap((x) =>
  [-0.5, -0.25, 0, 0.25].map((y) => [x * TEXEL, y * TEXEL] as const),
)

const skin = paintSkin(plainSheet())

/** Returns the weight at a position in millimetres, as the GPU filters it. */
function weightAt({ data }: GrayImage, x: number, y: number): number {
  const [column, row] = [(x + 50) / TEXEL - 0.5, (50 - y) / TEXEL - 0.5]
  const [left, top] = [Math.floor(column), Math.floor(row)]
  const [s, t] = [column - left, row - top]
  const at = (i: number, j: number) => data[(top + j) * SIZE + left + i]
  return (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1))
}

/** Returns the mean radius at which the weight of a dab falls to a tenth of its maximum, millimetres. */
function seenRadius(settings: { radius: number; softness: number }): number {
  const radii = PLACES.flatMap(([x, y]) => {
    const image = paint(empty(SIZE), settings, skin, pointNear(skin, x, y))
    const most = Math.max(...image.data)
    return DIRECTIONS.map((angle) => {
      let radius = 0
      for (let d = 0; d < settings.radius + 3 * TEXEL; d += 0.05)
        if (weightAt(image, x + d * Math.cos(angle), y + d * Math.sin(angle)) >= most / 10) radius = d
      return radius
    })
  })
  return radii.reduce((sum, radius) => sum + radius, 0) / radii.length
}

it.each([
  [0.5, 0],
  [0.5, 0.3],
  [0.5, 0.7],
  [2.5, 0],
  [2.5, 0.7],
  [10, 0],
])('the outline of a brush of %d mm and softness %d is as large as its dab', (radius, softness) => {
  const shown = visibleRadius(skin.mapOf(SIZE), { ...BRUSH_DEFAULTS, radius, softness }, 0)
  expect(Math.abs(shown - seenRadius({ radius, softness }))).toBeLessThan(0.15 * TEXEL)
})

it('the outline of a soft brush on small texels has the radius of the brush', () => {
  const brush = { ...BRUSH_DEFAULTS, radius: 10, softness: 1 }
  expect(visibleRadius(skin.mapOf(SIZE), brush, 0)).toBe(10)
})
