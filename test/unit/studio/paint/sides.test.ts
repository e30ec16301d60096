import { describe, expect, it } from 'vitest'
import { BRUSH_DEFAULTS, type Brush } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import { ball, empty, foldedSheet, meshOf, paintSkin, placesOf, plainSheet, pointNear } from './skins.ts'

const SIZE = 128
const brush = (settings: Partial<Brush>): Brush => ({ ...BRUSH_DEFAULTS, flow: 0.5, radius: 10, ...settings })

describe('mirror', () => {
  it.each(['add', 'smooth'] as const)('paints both sides alike, over the middle too: %s', (mode) => {
    const skin = paintSkin(plainSheet())
    const image = empty(SIZE)
    for (let i = 0; i < image.data.length; i++) {
      const column = i % SIZE
      image.data[i] = mode === 'add' ? 0 : 4 * Math.min(column, SIZE - 1 - column)
    }
    const stroke = new BrushStroke(image, brush({ mirror: true, mode }), skin)
    stroke.moveTo(pointNear(skin, -20, -20))
    stroke.moveTo(pointNear(skin, 12, 20))
    const { data } = stroke.end().image
    expect(data).not.toEqual(image.data)
    const differences = data.map((weight, i) =>
      Math.abs(weight - data[i - (i % SIZE) + SIZE - 1 - (i % SIZE)]),
    )
    expect(Math.max(...differences)).toBeLessThanOrEqual(1)
  })

  it('covers the middle no more than the sides', () => {
    const skin = paintSkin(plainSheet())
    const stroke = new BrushStroke(empty(SIZE), brush({ mirror: true }), skin)
    stroke.moveTo(pointNear(skin, 1, 0))
    expect(Math.max(...stroke.end().image.data)).toBe(128)
  })

  it('finds the nearest skin on the other side of a mesh that is not symmetric', () => {
    const skin = paintSkin(
      meshOf({ n: 20, m: 20, at: (i, j) => [100 * i - 50, 100 * j - 50, i > 0.5 ? 8 : 0, i, 1 - j] }),
    )
    const { position } = skin.mirrored([-30, 5, 0])
    for (const [k, value] of [30, 5, 8].entries()) expect(position[k]).toBeCloseTo(value, 4)
  })
})

describe('texels that both halves of a face use', () => {
  const skin = paintSkin(foldedSheet())
  const map = skin.mapOf(SIZE)

  it.each([25, -25, 3, -3])('are painted by a dab at x = %d on either half', (x) => {
    const stroke = new BrushStroke(empty(SIZE), brush({ flow: 1 }), skin)
    stroke.moveTo(pointNear(skin, x, 5))
    const places = [...placesOf(map, stroke.end().image)].filter(({ isBeyond }) => !isBeyond)
    for (const sign of [-1, 1]) {
      const near = places.filter((place) => Math.hypot(place.x - sign * Math.abs(x), place.y - 5) < 2)
      expect(near.length).toBeGreaterThan(5)
      expect(new Set(near.map(({ weight }) => weight))).toEqual(new Set([255]))
      expect(places.filter((place) => Math.abs(place.y - 5) > 11).every(({ weight }) => weight === 0)).toBe(
        true,
      )
    }
  })

  it('give what a dab has on one half, whichever it is', () => {
    const [left, right] = [17.3, -17.3].map((x) => {
      const stroke = new BrushStroke(empty(SIZE), brush({}), skin)
      stroke.moveTo(pointNear(skin, x, 5))
      return stroke.end().image
    })
    // Beyond the islands only the left half continues.
    const places = [...placesOf(map, left)].filter(({ isBeyond }) => !isBeyond)
    const differences = places.map(({ texel }) => Math.abs(left.data[texel] - right.data[texel]))
    expect(Math.max(...differences)).toBeLessThanOrEqual(1)
  })
})

describe('a closed surface', () => {
  it('is painted across all of its seams, with both sides alike', () => {
    const skin = paintSkin(ball())
    const stroke = new BrushStroke(empty(SIZE), brush({ flow: 1 }), skin)
    // Over the seam at z = 0 and the pole.
    for (const [x, y, z] of [
      [40, 0, 30],
      [40, 0, -30],
      [20, 40, -22],
      [0, 50, 0],
      [-20, 40, 22],
    ])
      stroke.moveTo(pointNear(skin, x, y, z))
    const { image } = stroke.end()
    const places = [...placesOf(skin.mapOf(SIZE), image)]
    const seam = places.filter(({ z, x, y }) => Math.abs(z) < 2 && x > 0 && Math.abs(y) < 12)
    const pairs = seam.flatMap((one) =>
      seam
        .map((other) => ({
          distance: Math.hypot(other.x - one.x, other.y - one.y, other.z - one.z),
          difference: Math.abs(other.weight - one.weight),
        }))
        .filter(({ distance }) => distance > 0 && distance < 1),
    )
    expect(pairs.length).toBeGreaterThan(20)
    // The softness of 0.7 falls by 1.5 / 7 per millimetre at most.
    expect(pairs.filter(({ distance, difference }) => difference > 2 + 55 * distance)).toEqual([])
  })
})
