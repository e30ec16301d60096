import type { GrayImage } from 'furrow'
import { type Stroke, skinCanvas, type Uv } from 'furrow/author'
import { expect, test } from 'vitest'
import { layAreaLines } from '../../../../packages/furrow/src/author/auto/lines/area-lines.ts'

const SIZE = 128
/** Sheet of 160 x 160 mm that fills its texture. */
const SIDE = 160
const SETTINGS = { age: 45, strength: 1, seed: 1, stream: 'area' }

const grid = Array.from({ length: 17 * 17 }, (_, i) => [(i % 17) / 16, Math.floor(i / 17) / 16])
const canvas = skinCanvas(
  {
    positions: grid.flatMap(([u, v]) => [SIDE * (u - 0.5), SIDE * (0.5 - v), 0]),
    uvs: grid.flat(),
    indices: Array.from({ length: 256 }, (_, i) => 17 * Math.floor(i / 16) + (i % 16)).flatMap((i) => [
      i,
      i + 17,
      i + 1,
      i + 1,
      i + 17,
      i + 18,
    ]),
  },
  SIZE,
  SIZE,
  1,
)

/** Paints an ellipse, whose radii are fractions of the sheet, turned by an angle. */
function ellipse(long: number, short: number, angle: number): GrayImage {
  const data = new Uint8Array(SIZE * SIZE)
  for (let i = 0; i < data.length; i++) {
    const [x, y] = [((i % SIZE) + 0.5) / SIZE - 0.5, (Math.floor(i / SIZE) + 0.5) / SIZE - 0.5]
    const [c, s] = [Math.cos(angle), Math.sin(angle)]
    const radius = Math.hypot((c * x + s * y) / long, (c * y - s * x) / short)
    data[i] = Math.round(255 * Math.min(1, Math.max(0, 3 - 3 * radius)))
  }
  return { width: SIZE, height: SIZE, data }
}

const lengthOf = ({ points }: Stroke) =>
  SIDE * Math.hypot(points.at(-1)![0] - points[0][0], points.at(-1)![1] - points[0][1])

test.each([0, 0.7, Math.PI / 2])('lines follow the long axis of an area that is turned by %d', (angle) => {
  const strokes = layAreaLines(canvas, ellipse(0.4, 0.2, angle), SETTINGS)
  expect(strokes.length).toBeGreaterThan(3)
  for (const { points } of strokes) {
    const [[u, v], [toU, toV]] = [points[0], points.at(-1)!]
    const off = Math.abs(Math.atan2(toV - v, toU - u) - angle) % Math.PI
    expect(Math.min(off, Math.PI - off)).toBeLessThan(0.35)
  }
})

test('lines stay in the area, and differ in length, depth and distance', () => {
  const area = ellipse(0.4, 0.2, 0)
  const strokes = layAreaLines(canvas, area, SETTINGS)
  const weight = ([u, v]: Uv) => area.data[Math.floor(v * SIZE) * SIZE + Math.floor(u * SIZE)]
  for (const { points } of strokes) expect(Math.min(...points.map(weight))).toBeGreaterThan(60)
  const heights = strokes.map(({ points }) => SIDE * points[points.length >> 1][1]).sort((a, b) => a - b)
  const gaps = heights.slice(1).map((height, i) => height - heights[i])
  const spread = (values: readonly number[]) => Math.max(...values) / Math.min(...values)
  expect(spread(strokes.map(lengthOf))).toBeGreaterThan(1.2)
  expect(spread(strokes.map(({ depth }) => depth))).toBeGreaterThan(1.1)
  expect(spread(gaps.filter((gap) => gap > 5))).toBeGreaterThan(1.05)
  for (const { taper, depth } of strokes) {
    expect(Math.min(...taper!)).toBeGreaterThan(0.2)
    expect(depth).toBeGreaterThan(0.1)
  }
})

test('the same seed draws the same lines, another one others', () => {
  const area = ellipse(0.3, 0.2, 0)
  const strokes = layAreaLines(canvas, area, SETTINGS)
  expect(layAreaLines(canvas, area, SETTINGS)).toEqual(strokes)
  expect(layAreaLines(canvas, area, { ...SETTINGS, seed: 2 })).not.toEqual(strokes)
})

test('thin skin has more lines than thick skin', () => {
  const area = ellipse(0.4, 0.3, 0)
  const count = (region: string) => layAreaLines(canvas, area, { ...SETTINGS, region }).length
  expect(count('nose')).toBeGreaterThan(1.3 * count('foreheadInner'))
})

test('a small area has lines, and an empty one none', () => {
  expect(layAreaLines(canvas, ellipse(0.08, 0.04, 0), SETTINGS).length).toBeGreaterThan(0)
  expect(layAreaLines(canvas, ellipse(0.001, 0.001, 0), SETTINGS)).toEqual([])
})
