import type { GrayImage } from 'furrow'
import { describe, expect, it } from 'vitest'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import type { PaintSkin } from '../../../../studio/src/paint/paint-skin.ts'
import { cutSheet, empty, lips, onIslands, paint, paintSkin, placesOf, pointNear } from './skins.ts'

const SIZE = 128

/** Returns weights that depend on the position on the skin. */
function drawn(skin: PaintSkin, weightAt: (x: number, y: number) => number, size = SIZE): GrayImage {
  const image = empty(size)
  for (const { x, y, texel } of placesOf(skin.mapOf(size), image)) image.data[texel] = weightAt(x, y)
  return image
}

describe('a brush that smooths', () => {
  const skin = paintSkin(cutSheet())
  const line = [pointNear(skin, -20, -10), pointNear(skin, 20, 25)]

  it('does not change even weights', () => {
    for (const weight of [0, 77, 255]) {
      const image = empty(SIZE, weight)
      const stroke = new BrushStroke(image, { ...BRUSH_DEFAULTS, mode: 'smooth', radius: 15 }, skin)
      for (const point of line) expect(stroke.moveTo(point)).toBeUndefined()
    }
  })

  it('makes a step flatter within its radius, and more so at higher flow', () => {
    const step = drawn(skin, (x) => (x < 0 ? 40 : 200))
    const steepest = (image: GrayImage) => {
      const row = onIslands(skin, image).filter(({ x, y }) => y > -14 && y < -6 && Math.abs(x) < 3)
      const weights = row.map(({ weight }) => weight)
      return Math.max(...weights) - Math.min(...weights)
    }
    const across = [pointNear(skin, -10, -10), pointNear(skin, 10, -10)]
    const [weak, strong] = [0.1, 1].map((flow) =>
      paint(step, { mode: 'smooth', radius: 12, flow }, skin, ...across),
    )
    expect(steepest(step)).toBe(160)
    expect(steepest(weak)).toBeLessThan(steepest(step))
    expect(steepest(strong)).toBeLessThan(0.5 * steepest(weak))
    const changed = [...placesOf(skin.mapOf(SIZE), strong)].filter(
      ({ texel, weight }) => weight !== step.data[texel],
    )
    expect(changed.filter(({ x, y }) => Math.hypot(Math.max(Math.abs(x) - 10, 0), y + 10) > 12)).toEqual([])
  })

  it('gives both sides of a seam the same weights', () => {
    // One step of the weights crosses the seam at y = 10, and another one runs along it.
    const step = drawn(skin, (x, y) => (x < 0 === y < 10 ? 40 : 200), 256)
    const across = [pointNear(skin, -25, 10), pointNear(skin, 25, 10)]
    const image = paint(step, { mode: 'smooth', radius: 15 }, skin, ...across)
    const near = [...placesOf(skin.mapOf(256), image)].filter(
      ({ x, y }) => Math.abs(x) < 20 && Math.abs(y - 10) < 0.8,
    )
    const differences = near.flatMap((one) =>
      near
        .filter((other) => other !== one && Math.hypot(other.x - one.x, other.y - one.y) < 0.5)
        .map(({ weight }) => Math.abs(weight - one.weight)),
    )
    expect(differences.length).toBeGreaterThan(20)
    expect(Math.max(...differences)).toBeLessThan(12)
  })

  it('does not mix weights of skin that is not connected', () => {
    const mouth = paintSkin(lips())
    const image = drawn(mouth, (_, y) => (y > 0 ? 255 : 0))
    const across = [pointNear(mouth, -30, 2), pointNear(mouth, 0, 2)]
    const smoothed = paint(image, { mode: 'smooth', radius: 10 }, mouth, ...across)
    const mixed = onIslands(mouth, smoothed).filter(({ y, weight }) => weight !== (y > 0 ? 255 : 0))
    expect(mixed.filter(({ x }) => x < 40)).toEqual([])
  })
})

describe('a fill', () => {
  const skin = paintSkin(cutSheet())
  const ring = (x: number, y: number) => Math.abs(Math.hypot(x, y - 10) - 25)

  it('covers the inside of an outline, also across a seam, and nothing else', () => {
    const outline = drawn(skin, (x, y) => (ring(x, y) < 3 ? 255 : 0))
    const filled = paint(outline, { mode: 'fill' }, skin, pointNear(skin, 3, 2))
    const places = [...placesOf(skin.mapOf(SIZE), filled)].filter(
      ({ y, isBeyondIsland }) => !isBeyondIsland || Math.abs(y - 10) < 1,
    )
    expect(places.filter(({ x, y, weight }) => Math.hypot(x, y - 10) < 27 && weight < 255)).toEqual([])
    expect(places.filter(({ x, y, weight }) => Math.hypot(x, y - 10) > 29 && weight > 0)).toEqual([])
  })

  it('leaves no gap at a soft outline, and keeps the outer border of the outline', () => {
    const outline = drawn(skin, (x, y) => Math.max(0, 255 - 30 * ring(x, y)))
    const filled = paint(outline, { mode: 'fill' }, skin, pointNear(skin, 3, 2))
    const places = onIslands(skin, filled)
    expect(places.filter(({ x, y, weight }) => Math.hypot(x, y - 10) < 24 && weight < 255)).toEqual([])
    const outside = places.filter(({ x, y }) => Math.hypot(x, y - 10) > 27)
    expect(outside.filter(({ texel, weight }) => weight !== outline.data[texel])).toEqual([])
  })

  it('raises the weights of the spot on which it starts to the full weight', () => {
    const spot = drawn(skin, (x, y) => (Math.hypot(x, y - 10) < 20 ? 180 : 60))
    const filled = paint(spot, { mode: 'fill' }, skin, pointNear(skin, 3, 2))
    const wrong = onIslands(skin, filled).filter(
      ({ x, y, weight }) => weight !== (Math.hypot(x, y - 10) < 20 ? 255 : 60),
    )
    expect(wrong).toEqual([])
  })

  it('covers all of the skin if nothing encloses its start, also beyond the islands', () => {
    const filled = paint(empty(SIZE), { mode: 'fill', opacity: 0.5 }, skin, pointNear(skin, 3, 2))
    const weights = new Set([...placesOf(skin.mapOf(SIZE), filled)].map(({ weight }) => weight))
    expect(weights).toEqual(new Set([128]))
  })

  it('spreads to the other lip through the corner of the mouth, but not directly', () => {
    const mouth = paintSkin(lips())
    const closed = drawn(mouth, (x) => (x > 38 ? 255 : 0))
    const filled = paint(closed, { mode: 'fill' }, mouth, pointNear(mouth, -30, 2))
    const wrong = onIslands(mouth, filled).filter(
      ({ x, y, weight }) => x < 38 && weight !== (y > 0 ? 255 : 0),
    )
    expect(wrong).toEqual([])
    const open = paint(empty(SIZE), { mode: 'fill' }, mouth, pointNear(mouth, -30, 2))
    expect([...placesOf(mouth.mapOf(SIZE), open)].every(({ weight }) => weight === 255)).toBe(true)
  })

  it('happens only once, at the start of a stroke', () => {
    const outline = drawn(skin, (x, y) => (ring(x, y) < 3 ? 255 : 0))
    const points = [pointNear(skin, 3, 2), pointNear(skin, 45, 45)]
    expect(paint(outline, { mode: 'fill' }, skin, ...points).data).toEqual(
      paint(outline, { mode: 'fill' }, skin, points[0]).data,
    )
  })
})
