import { describe, expect, it } from 'vitest'
import {
  ball,
  empty,
  foldedSheet,
  meshOf,
  onIslands,
  paint,
  paintSkin,
  placesOf,
  plainSheet,
  pointNear,
} from './skins.ts'

const SIZE = 128
const BRUSH = { flow: 0.5, radius: 10 }

describe('mirror', () => {
  it.each(['add', 'smooth'] as const)('paints both sides equally, also across the middle: %s', (mode) => {
    const skin = paintSkin(plainSheet())
    const image = empty(SIZE)
    for (let i = 0; i < image.data.length; i++) {
      const column = i % SIZE
      image.data[i] = mode === 'add' ? 0 : 4 * Math.min(column, SIZE - 1 - column)
    }
    const points = [pointNear(skin, -20, -20), pointNear(skin, 12, 20)]
    const { data } = paint(image, { ...BRUSH, mirror: true, mode }, skin, ...points)
    expect(data).not.toEqual(image.data)
    const differences = data.map((weight, i) =>
      Math.abs(weight - data[i - (i % SIZE) + SIZE - 1 - (i % SIZE)]),
    )
    expect(Math.max(...differences)).toBeLessThanOrEqual(1)
  })

  it('gives the middle of the face no more weight than the sides', () => {
    const skin = paintSkin(plainSheet())
    const { data } = paint(empty(SIZE), { ...BRUSH, mirror: true }, skin, pointNear(skin, 1, 0))
    expect(Math.max(...data)).toBe(128)
  })

  it('finds the nearest skin on the other side of an asymmetric mesh', () => {
    const skin = paintSkin(
      meshOf({ n: 20, m: 20, at: (i, j) => [100 * i - 50, 100 * j - 50, i > 0.5 ? 8 : 0, i, 1 - j] }),
    )
    const { position } = skin.mirrored([-30, 5, 0])
    for (const [k, value] of [30, 5, 8].entries()) expect(position[k]).toBeCloseTo(value, 4)
  })
})

describe('the texels that both halves of a face share', () => {
  const skin = paintSkin(foldedSheet())

  it.each([25, -25, 3, -3])('are painted by a dab at x = %d on either half', (x) => {
    const places = onIslands(skin, paint(empty(SIZE), { radius: 10 }, skin, pointNear(skin, x, 5)))
    for (const sign of [-1, 1]) {
      const near = places.filter((place) => Math.hypot(place.x - sign * Math.abs(x), place.y - 5) < 2)
      expect(near.length).toBeGreaterThan(5)
      expect(new Set(near.map(({ weight }) => weight))).toEqual(new Set([255]))
      expect(places.filter((place) => Math.abs(place.y - 5) > 11).every(({ weight }) => weight === 0)).toBe(
        true,
      )
    }
  })

  it('give a dab the same weights from either half', () => {
    const [left, right] = [17.3, -17.3].map((x) => paint(empty(SIZE), BRUSH, skin, pointNear(skin, x, 5)))
    // Points beyond the islands are left out, because only the left half has them.
    const differences = onIslands(skin, left).map(({ texel }) =>
      Math.abs(left.data[texel] - right.data[texel]),
    )
    expect(Math.max(...differences)).toBeLessThanOrEqual(1)
  })
})

describe('a closed surface', () => {
  it('is painted across all of its seams, with equal weights on both sides', () => {
    const skin = paintSkin(ball())
    // The stroke crosses the seam at z = 0, and the pole.
    const points = [
      pointNear(skin, 40, 0, 30),
      pointNear(skin, 40, 0, -30),
      pointNear(skin, 20, 40, -22),
      pointNear(skin, 0, 50, 0),
      pointNear(skin, -20, 40, 22),
    ]
    const image = paint(empty(SIZE), { radius: 10 }, skin, ...points)
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
    // With a softness of 0.7, the falloff is at most 1.5 / 7 per millimetre.
    expect(pairs.filter(({ distance, difference }) => difference > 2 + 55 * distance)).toEqual([])
  })
})
