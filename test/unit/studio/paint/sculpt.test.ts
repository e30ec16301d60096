import { describe, expect, it } from 'vitest'
import type { SculptBrush } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import type { PaintSkin, SkinPoint } from '../../../../studio/src/paint/paint-skin.ts'
import {
  brushOf,
  SCULPT_DEFAULTS,
  type SculptSettings,
} from '../../../../studio/src/tools/sculpt-settings.ts'
import { foldedSheet, lips, paintSkin, plainSheet, pointNear } from './skins.ts'

const SIZE = 128

function heights(heightAt: (x: number, y: number) => number = () => 0) {
  const data = Int16Array.from({ length: SIZE ** 2 }, (_, i) => heightAt(i % SIZE, Math.floor(i / SIZE)))
  return { width: SIZE, height: SIZE, data }
}

/** Sculpts a stroke through points of a skin, and returns the heights. */
function sculpt(
  image: ReturnType<typeof heights>,
  settings: Partial<SculptSettings>,
  skin: PaintSkin,
  points: readonly SkinPoint[],
  more: Partial<SculptBrush> = {},
  pressure = 1,
) {
  const brush = { ...brushOf({ ...SCULPT_DEFAULTS, radius: 15, ...settings }), flow: 1, ...more }
  const stroke = new BrushStroke(image, brush, skin)
  for (const point of points) stroke.moveTo(point, pressure)
  return stroke.end().image
}

/** Texel of the plain sheet at a position, millimetres. */
const texelAt = (x: number, y: number) =>
  Math.floor(((50 - y) / 100) * SIZE) * SIZE + Math.floor(((x + 50) / 100) * SIZE)

describe('a brush that sculpts', () => {
  const skin = paintSkin(plainSheet())
  const middle = pointNear(skin, 0.4, 0.4)
  const line = [pointNear(skin, -20, 0), pointNear(skin, 20, 0), pointNear(skin, -20, 0)]

  it.each([
    ['raise', 500],
    ['lower', -500],
  ] as const)(
    'in the mode %s moves skin by its height, also where the stroke crosses itself',
    (mode, step) => {
      const { data } = sculpt(heights(), { mode, height: 0.5 }, skin, line)
      expect(data[texelAt(0, 0)]).toBeCloseTo(step, -1)
      expect(Math.max(...data.map(Math.abs))).toBeLessThanOrEqual(500)
      expect(data[texelAt(0, 20)]).toBe(0)
    },
  )

  it('adds to what is already sculpted, up to 10 mm', () => {
    const once = sculpt(heights(), { height: 5 }, skin, [middle])
    expect(Math.max(...sculpt(once, { height: 3 }, skin, [middle]).data)).toBeCloseTo(8000, -2)
    const twice = sculpt(once, { height: 5 }, skin, [middle])
    expect(Math.max(...sculpt(twice, { height: 5 }, skin, [middle]).data)).toBe(10_000)
  })

  it('has less effect with less pressure', () => {
    const { data } = sculpt(heights(), { height: 1 }, skin, [middle], {}, 0.25)
    expect(data[texelAt(0, 0)]).toBeCloseTo(250, -1)
  })

  it('smooths a step, and keeps even heights', () => {
    const step = heights((x) => (x < SIZE / 2 ? -400 : 400))
    const { data } = sculpt(step, { mode: 'smooth', strength: 1 }, skin, line)
    const jump = data[texelAt(1, 0)] - data[texelAt(-1, 0)]
    expect(jump).toBeLessThan(500)
    const even = heights(() => 300)
    expect(sculpt(even, { mode: 'smooth', strength: 1 }, skin, line)).toEqual(even)
  })

  it('flattens towards the mean height under its first dab', () => {
    const noisy = heights((x, y) => 600 + 200 * ((x + y) % 2))
    const { data } = sculpt(noisy, { mode: 'flatten', strength: 1, softness: 0 }, skin, line)
    for (const x of [-10, 0, 10]) expect(data[texelAt(x, 0)]).toBeCloseTo(700, -1)
    expect(data[texelAt(0, 30)]).toBe(noisy.data[texelAt(0, 30)])
  })

  it('sculpts both halves with the mirror, and not the other lip', () => {
    const { data } = sculpt(heights(), { mirror: true, radius: 5 }, skin, [pointNear(skin, 20.4, 10)])
    expect(data[texelAt(20, 10)]).toBeGreaterThan(400)
    expect(data[texelAt(-20, 10)]).toBeCloseTo(data[texelAt(20, 10)], -1.5)
    const mouth = paintSkin(lips())
    const upper = sculpt(heights(), { radius: 8, softness: 0 }, mouth, [pointNear(mouth, 0, 4)])
    expect(upper.data.filter((step, i) => step !== 0 && i > SIZE * SIZE * 0.52)).toEqual(new Int16Array())
    const folded = paintSkin(foldedSheet())
    const both = sculpt(heights(), { mirror: true, height: 0.5 }, folded, [pointNear(folded, 20, 0)])
    expect(Math.max(...both.data)).toBeLessThanOrEqual(500)
  })

  it('presses a stamp into the skin, the right way up, and mirrored on the other half', () => {
    // White at the upper left.
    const image = { width: 2, height: 2, data: Uint8Array.of(255, 0, 0, 0) }
    const settings = { stamp: { name: 'corner', image }, softness: 0, radius: 10, mirror: true }
    const { data } = sculpt(heights(), settings, skin, [pointNear(skin, 25.4, 0.4)])
    const near = (dx: number, dy: number, x = 25) => data[texelAt(x + dx, dy)]
    expect(near(-6, 6)).toBeGreaterThan(400)
    for (const [dx, dy] of [
      [6, 6],
      [-6, -6],
      [6, -6],
    ])
      expect(near(dx, dy)).toBeLessThan(50)
    expect(near(6, 6, -25)).toBeGreaterThan(400)
    expect(near(-6, 6, -25)).toBeLessThan(50)
  })

  it('leaves the space between stamps free', () => {
    const image = {
      width: 8,
      height: 8,
      data: Uint8Array.from({ length: 64 }, (_, i) => (i % 8 > 2 && i % 8 < 5 ? 255 : 0)),
    }
    const settings = { stamp: { name: 'dot', image }, softness: 0, radius: 5 }
    const { data } = sculpt(heights(), settings, skin, [pointNear(skin, -20, 0), pointNear(skin, 20, 0)])
    const row = Array.from({ length: 41 }, (_, i) => data[texelAt(i - 20, 0)] > 250)
    expect(row.filter((isHigh, i) => isHigh && !row[i - 1]).length).toBe(5)
  })
})
