import { FurrowError, type GrayImage } from 'furrow'
import { describe, expect, it } from 'vitest'
import { BRUSH_DEFAULTS, type Brush, falloff } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import type { PaintSkin, SkinPoint } from '../../../../studio/src/paint/paint-skin.ts'
import {
  cutSheet,
  empty,
  lips,
  onIslands,
  paint,
  paintSkin,
  placesOf,
  plainSheet,
  pointNear,
} from './skins.ts'

const SIZE = 256
const brush = (settings: Partial<Brush> = {}): Brush => ({
  ...BRUSH_DEFAULTS,
  flow: 1,
  radius: 15,
  ...settings,
})

/** Paints a stroke through points of the skin. */
const paintOn = (
  skin: PaintSkin,
  points: readonly (SkinPoint | undefined)[],
  settings: Partial<Brush> = {},
  image = empty(SIZE),
) => paint(image, { radius: 15, ...settings }, skin, ...points)

const largestDifference = (a: GrayImage, b: GrayImage) =>
  a.data.reduce((worst, value, i) => Math.max(worst, Math.abs(value - b.data[i])), 0)

/** Returns points of the skin at equal distances along a polyline. */
const along = (skin: PaintSkin, corners: readonly [number, number][], samples: number): SkinPoint[] => {
  const lengths = corners.slice(1).map(([x, y], i) => Math.hypot(x - corners[i][0], y - corners[i][1]))
  const total = lengths.reduce((sum, length) => sum + length, 0)
  return Array.from({ length: samples }, (_, n) => {
    let left = (total * n) / (samples - 1)
    let i = 0
    while (i < lengths.length - 1 && left > lengths[i]) left -= lengths[i++]
    const t = Math.min(left / lengths[i], 1)
    const [[x, y], [toX, toY]] = [corners[i], corners[i + 1]]
    return pointNear(skin, x + t * (toX - x), y + t * (toY - y))
  })
}

describe('the falloff of a brush', () => {
  it('is 1 in the hard centre, 0.5 in the middle of the soft border and 0 at the radius and beyond', () => {
    expect(falloff(0, 10, 1)).toBe(1)
    expect(falloff(5.9, 10, 0.4)).toBe(1)
    expect(falloff(8, 10, 0.4)).toBeCloseTo(0.5, 12)
    expect(falloff(9, 10, 0.4)).toBeCloseTo(1 - (3 * 0.75 ** 2 - 2 * 0.75 ** 3), 12)
    expect(falloff(10, 10, 0.4)).toBe(0)
  })

  it('changes from 1 to 0 at the radius for a hard brush', () => {
    expect(falloff(9.999, 10, 0)).toBe(1)
    expect(falloff(10, 10, 0)).toBe(0)
  })
})

describe('a dab', () => {
  const skin = paintSkin(cutSheet())
  const map = skin.mapOf(SIZE)

  it.each([0, 0.3, 1])(
    'of softness %d has its falloff on both sides of a seam, and where islands continue for filtering',
    (softness) => {
      const image = paintOn(skin, [pointNear(skin, 5, 8)], { softness })
      let [below, above, beyond, worst] = [0, 0, 0, 0]
      for (const { x, y, weight, isBeyondIsland } of placesOf(map, image)) {
        const distance = Math.hypot(x - 5, y - 8)
        if (isBeyondIsland && !(distance < 15 && Math.abs(y - 10) < 1)) continue
        worst = Math.max(worst, Math.abs(weight - 255 * falloff(distance, 15, softness)))
        if (weight > 0 && isBeyondIsland) beyond++
        else if (weight > 0 && y < 10) below++
        else if (weight > 0) above++
      }
      expect(worst).toBeLessThanOrEqual(1)
      expect(Math.min(below, above)).toBeGreaterThan(300)
      expect(beyond).toBeGreaterThan(30)
    },
  )

  it('is as wide on a map of another size', () => {
    for (const size of [64, 400]) {
      const image = paintOn(skin, [pointNear(skin, 5, 8)], {}, empty(size))
      let worst = 0
      for (const { x, y, weight, isBeyondIsland } of placesOf(skin.mapOf(size), image)) {
        const expected = 255 * falloff(Math.hypot(x - 5, y - 8), 15, 0.7)
        if (!isBeyondIsland) worst = Math.max(worst, Math.abs(weight - expected))
      }
      expect(worst).toBeLessThanOrEqual(1)
    }
  })

  it('covers at least one texel, however small the brush is', () => {
    for (let x = -20; x < 20; x += 1.7) {
      const image = paintOn(skin, [pointNear(skin, x, x / 3)], { radius: 0.1 }, empty(32))
      expect(Math.max(...image.data)).toBeGreaterThan(100)
    }
  })

  it('does not reach the other lip if the skin does not connect them within its radius', () => {
    const mouth = paintSkin(lips())
    const image = paintOn(mouth, [pointNear(mouth, -10, 2)])
    const weights = onIslands(mouth, image)
    expect(weights.some(({ y, weight }) => y > 0 && weight === 255)).toBe(true)
    expect(weights.every(({ y, weight }) => y > 0 || weight === 0)).toBe(true)
  })

  it('reaches the other lip at the corner of the mouth', () => {
    const mouth = paintSkin(lips())
    const image = paintOn(mouth, [pointNear(mouth, 48, 2)])
    const weights = [...placesOf(mouth.mapOf(SIZE), image)]
    expect(weights.some(({ y, weight, isBeyondIsland }) => !isBeyondIsland && y < -1 && weight > 200)).toBe(
      true,
    )
  })
})

describe('a stroke', () => {
  const skin = paintSkin(cutSheet())
  const corners: [number, number][] = [
    [-30, -20],
    [-10, 25],
    [10, 0],
    [20, 30],
    [30, -30],
  ]

  it.each([1, 0.2])('of flow %d is the same whether the pointer reports 5 points or 500', (flow) => {
    const few = paintOn(
      skin,
      along(skin, corners, 5).map((_, i) => pointNear(skin, ...corners[i])),
      { flow, radius: 6 },
    )
    const lengths = corners.slice(1).map(([x, y], i) => Math.hypot(x - corners[i][0], y - corners[i][1]))
    // The points include all corners of the path.
    const points = corners.slice(1).flatMap((corner, i) => {
      const count = Math.round(lengths[i] / 0.34)
      return along(skin, [corners[i], corner], count).slice(i === 0 ? 0 : 1)
    })
    expect(points.length).toBeGreaterThan(490)
    expect(largestDifference(few, paintOn(skin, points, { flow, radius: 6 }))).toBeLessThanOrEqual(1)
  })

  it('has weights that depend only on the distance from its line, also across seams', () => {
    const image = paintOn(skin, [pointNear(skin, -20, -20), pointNear(skin, 20, 30)], { softness: 1 })
    const length = Math.hypot(40, 50)
    let worst = 0
    for (const { x, y, weight, isBeyondIsland } of placesOf(skin.mapOf(SIZE), image)) {
      const t = ((x + 20) * 40 + (y + 20) * 50) / length ** 2
      if (isBeyondIsland || t < 0 || t > 1) continue
      const distance = Math.abs((x + 20) * 50 - (y + 20) * 40) / length
      worst = Math.max(worst, Math.abs(weight - 255 * falloff(distance, 15, 1)))
    }
    // Between two dabs, the distance to the nearest dab is slightly larger than to the line.
    expect(worst).toBeLessThanOrEqual(2)
  })

  it('gets closer to its opacity with each pass, by its flow, and never exceeds it', () => {
    const point = pointNear(skin, 0, -10)
    const [, beside] = [point, pointNear(skin, 0, -10.001)]
    const peak = (points: SkinPoint[], settings: Partial<Brush>) =>
      Math.max(...paintOn(skin, points, settings).data)
    expect(peak([point], { flow: 0.25 })).toBe(Math.round(0.25 * 255))
    const again = [point, pointNear(skin, 20, -10), pointNear(skin, -20, -10), pointNear(skin, 20, -10)]
    expect(peak(again, { flow: 0.25, opacity: 0.6 })).toBe(Math.round(0.6 * 255))
    // A pointer that hardly moves adds nothing.
    expect(peak([point, point, beside, point], { flow: 0.25 })).toBe(Math.round(0.25 * 255))
  })

  it('keeps its soft border at full flow where it passes twice', () => {
    const line = [pointNear(skin, -20, -20), pointNear(skin, 20, -20)]
    const [once, thrice] = [paintOn(skin, line), paintOn(skin, [...line, line[0], line[1]])]
    let worst = 0
    for (const { x, texel, weight } of placesOf(skin.mapOf(SIZE), once)) {
      if (Math.abs(x) < 15) worst = Math.max(worst, Math.abs(weight - thrice.data[texel]))
    }
    expect(worst).toBeLessThanOrEqual(2)
  })

  it('can add to existing weights, or reduce them', () => {
    const point = pointNear(skin, 0, -10)
    const half = empty(SIZE, 128)
    const centre = (image: GrayImage) => {
      const places = [...placesOf(skin.mapOf(SIZE), image)].filter(({ x, y }) => Math.hypot(x, y + 10) < 1)
      return new Set(places.map(({ weight }) => weight))
    }
    expect(centre(paintOn(skin, [point], {}, half))).toEqual(new Set([255]))
    expect(centre(paintOn(skin, [point], { opacity: 0.5 }, half))).toEqual(
      new Set([Math.round(128 + 127 / 2)]),
    )
    expect(centre(paintOn(skin, [point], { mode: 'remove' }, half))).toEqual(new Set([0]))
    expect(centre(paintOn(skin, [point], { mode: 'remove', opacity: 0.5 }, half))).toEqual(new Set([64]))
    expect(half.data.every((weight) => weight === 128)).toBe(true)
  })

  it('is fainter with less pen pressure, which changes evenly between two points', () => {
    const stroke = new BrushStroke(empty(SIZE), brush({ radius: 5, softness: 0 }), skin)
    stroke.moveTo(pointNear(skin, -40, -20), 0)
    stroke.moveTo(pointNear(skin, 40, -20), 1)
    let worst = 0
    for (const { x, y, weight } of placesOf(skin.mapOf(SIZE), stroke.end().image)) {
      if (Math.abs(y + 20) > 2 || Math.abs(x) > 30) continue
      // Pressure grows along the stroke. A texel gets the weight of the last dab that covers it. This dab's centre is a radius ahead.
      worst = Math.max(worst, Math.abs(weight / 255 - (x + 40 + 5) / 80))
    }
    expect(worst).toBeLessThan(0.02)
  })

  it('starts again after the pointer has left the face', () => {
    const ends = [pointNear(skin, -30, -30), pointNear(skin, 30, -30)]
    const apart = paintOn(skin, [ends[0], undefined, ends[1]], { radius: 5 })
    const places = [...placesOf(skin.mapOf(SIZE), apart)]
    expect(places.some(({ x, weight }) => Math.abs(x) < 20 && weight > 0)).toBe(false)
    expect(paintOn(skin, [undefined]).data.every((weight) => weight === 0)).toBe(true)
  })

  it('starts again if the skin does not connect two points', () => {
    const mouth = paintSkin(lips())
    const image = paintOn(mouth, [pointNear(mouth, -20, 20), pointNear(mouth, -20, -20)], { radius: 5 })
    const weights = onIslands(mouth, image)
    expect(
      weights
        .filter(({ weight }) => weight > 0)
        .every(({ x, y }) => Math.abs(x + 20) <= 5 && Math.abs(y) >= 15),
    ).toBe(true)
  })

  it('reports the changed bounds after each move, and all of them at the end', () => {
    const image = empty(SIZE)
    const stroke = new BrushStroke(image, brush({ radius: 4 }), skin)
    let before = image.data.slice()
    for (const point of [...along(skin, corners, 9), undefined]) {
      const dirty = stroke.moveTo(point)
      expect(dirty).toEqual(boundsOf(before, stroke.image))
      before = stroke.image.data.slice()
    }
    const painted = stroke.end()
    expect(painted.image.data).toEqual(before)
    expect(painted.dirty).toEqual(boundsOf(image.data, painted.image))
    expect(image.data.every((weight) => weight === 0)).toBe(true)
  })

  it('changes nothing off the face, and reports no change', () => {
    const stroke = new BrushStroke(empty(SIZE), brush(), skin)
    expect(stroke.moveTo(undefined)).toBeUndefined()
    expect(stroke.end().dirty).toBeUndefined()
  })
})

describe('a stroke in the texture', () => {
  const skin = paintSkin(cutSheet())

  it('also paints the skin across a seam', () => {
    const stroke = new BrushStroke(empty(SIZE), brush({ radius: 8 }), skin)
    // The point is just below the seam at y = 10, on the left of the texture.
    stroke.moveInTexture(0.2, 0.69)
    const places = [...placesOf(skin.mapOf(SIZE), stroke.end().image)]
    expect(places.some(({ y, isBeyondIsland, weight }) => y > 12 && !isBeyondIsland && weight > 0)).toBe(true)
  })

  it('is straight in the texture, and does not paint along the skin between two islands', () => {
    const stroke = new BrushStroke(empty(SIZE), brush({ radius: 2 }), skin)
    stroke.moveInTexture(0.1, 0.8)
    stroke.moveInTexture(0.9, 0.7)
    const painted = [...placesOf(skin.mapOf(SIZE), stroke.end().image)].filter(({ weight }) => weight > 0)
    const uv = painted.map(({ texel }) => [(texel % SIZE) / SIZE, Math.floor(texel / SIZE) / SIZE])
    const onLine = uv.filter(([u, v]) => Math.abs(v - (0.8 - (u - 0.1) / 8)) < 0.04)
    expect(onLine.length).toBe(uv.length)
    expect(uv.some(([u]) => u > 0.8)).toBe(true)
  })
})

describe('invalid input for painting', () => {
  const skin = paintSkin(plainSheet())
  it.each([
    [{ radius: 0 }, 'radius'],
    [{ radius: Number.NaN }, 'radius'],
    [{ radius: 1e9 }, 'radius'],
    [{ softness: -0.1 }, 'softness'],
    [{ softness: Number.NaN }, 'softness'],
    [{ flow: 0 }, 'flow'],
    [{ flow: 1.1 }, 'flow'],
    [{ opacity: 2 }, 'opacity'],
    [{ mode: 'blur' as never }, 'mode'],
  ])('is refused: %j', (settings, name) => {
    const begin = () => new BrushStroke(empty(SIZE), brush(settings), skin)
    expect(begin).toThrow(FurrowError)
    expect(begin).toThrow(name)
  })

  it.each([
    ['another side than 2 to 2048', empty(4096)],
    ['one texel', empty(1)],
    ['a rectangle', { width: 2, height: 4, data: new Uint8Array(8) }],
    ['too few bytes', { width: 4, height: 4, data: new Uint8Array(8) }],
  ])('is refused: an area of %s', (_, image) => {
    expect(() => new BrushStroke(image, brush(), skin)).toThrow(FurrowError)
  })

  it('is replaced by no or full pressure if it is the pressure of a pen', () => {
    for (const [pressure, peak] of [
      [-1, 0],
      [Number.NaN, 0],
      [7, 255],
    ]) {
      const stroke = new BrushStroke(empty(SIZE), brush(), skin)
      stroke.moveTo(pointNear(skin, 0, 0), pressure)
      expect(Math.max(...stroke.end().image.data)).toBe(peak)
    }
  })
})

/** Returns the bounds of the texels whose weights differ. */
function boundsOf(before: Uint8Array, { width, data }: GrayImage) {
  const changed = [...data.keys()].filter((i) => data[i] !== before[i])
  if (changed.length === 0) return undefined
  const [xs, ys] = [changed.map((i) => i % width), changed.map((i) => Math.floor(i / width))]
  const [x, y] = [Math.min(...xs), Math.min(...ys)]
  return { x, y, width: Math.max(...xs) - x + 1, height: Math.max(...ys) - y + 1 }
}
