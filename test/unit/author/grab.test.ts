import { type Stroke, skinCanvas } from 'furrow/author'
import {
  findForks,
  grabPoint,
  grabWeights,
  mirrorStroke,
  moveFork,
  StrokeLines,
  strokeCurves,
} from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { cylinder, placeOf, RADIUS, strokeOn, uvOf } from './skins.ts'

const skin = skinCanvas(cylinder(), 64)
const lines = new StrokeLines(skin)

const turns = Array.from({ length: 13 }, (_, i) => 0.4 + 0.1 * i)
const heightsOf = ({ points }: Stroke) => points.map((uv) => placeOf(uv)[1])

describe('a grabbed point', () => {
  const level = strokeOn(turns.map((turn) => [turn, 30]))
  const grab = (strokes: readonly Stroke[], radius: number, y = 40) =>
    grabPoint({ strokes, forks: findForks(strokes, lines), lines }, 0, 6, { uv: uvOf(1, y), radius })

  it('takes its neighbours along, less the farther they are, over the seam of the texture', () => {
    const moved = grab([level], 20)
    const rises = heightsOf(moved).map((height) => height - 30)
    expect(moved.points[6]).toEqual(uvOf(1, 40))
    // The points are 2 * PI mm apart.
    for (const [i, rise] of rises.entries()) {
      const far = (Math.abs(i - 6) * 0.1 * Math.PI * RADIUS) / 20
      const weight = far < 1 ? 1 - far * far * (3 - 2 * far) : 0
      expect(rise).toBeCloseTo(10 * weight, 1)
    }
    for (const [i, uv] of level.points.entries()) if (Math.abs(i - 6) > 3) expect(moved.points[i]).toBe(uv)
  })

  it('moves alone with the radius 0', () => {
    expect(grab([level], 0).points).toEqual(level.points.with(6, uvOf(1, 40)))
  })

  it('leaves an end in its fork, and bends the line up to there', () => {
    const trunk = strokeOn([[0.4, 20], [0.4, 40]]) // biome-ignore format: one line
    const moved = grab([level, trunk], 60)
    expect(moved.points[0]).toBe(level.points[0])
    expect(heightsOf(moved)[1]).toBeGreaterThan(30.2)
    // The other end is free.
    expect(heightsOf(moved)[12]).toBeGreaterThan(32)
  })

  it('stops its neighbours at the border of the skin', () => {
    const high = strokeOn(turns.map((turn, i) => [turn, i < 6 ? 55 : 30]))
    for (const height of heightsOf(grab([high], 40, 45))) expect(height).toBeLessThanOrEqual(60.01)
  })

  it('has a counterpart that the mirror image of the whole line describes', () => {
    const half = strokeOn([0.55, 0.65, 0.75, 0.85, 0.95].map((turn) => [turn, 30]))
    const forked = { strokes: [half], forks: [], lines }
    const moved = grabPoint(forked, 0, 2, { uv: uvOf(0.75, 36), radius: 15 })
    const [[own], [image]] = [moved, mirrorStroke(moved, skin)].map((each) => strokeCurves(each, skin))
    expect(image.points.length).toBe(own.points.length)
    for (let i = 0; i < own.points.length; i += 30) {
      expect(image.points[i]).toBeCloseTo(-own.points[i], 4)
      expect(image.points[i + 1]).toBeCloseTo(own.points[i + 1], 4)
    }
  })
})

it('a grabbed fork bends all lines that meet there', () => {
  const [left, right, down] = [
    strokeOn([0.5, 0.6, 0.7, 0.8].map((turn) => [turn, 30])),
    strokeOn([0.8, 0.9, 1, 1.1].map((turn) => [turn, 30])),
    strokeOn([[0.8, 30], [0.8, 24], [0.8, 10]]), // biome-ignore format: one line
  ]
  const strokes = [left, right, down]
  const forks = findForks(strokes, lines)
  const moved = moveFork({ strokes, forks, lines }, forks[0], uvOf(0.8, 36), 15)
  expect([...moved.keys()].sort()).toEqual([0, 1, 2])
  const rises = [...moved].map(([i, each]) => heightsOf(each).map((y, k) => y - heightsOf(strokes[i])[k]))
  expect(rises.map(([, second]) => second > 0.2 && second < 6)).toEqual([true, true, true])
  expect(moved.get(0)!.points[0]).toBe(left.points[0])
})

it('weights of a grab fall from 1 to 0 within the radius', () => {
  const line = { lengths: Float64Array.of(0, 5, 10, 15, 20), knots: [0, 1, 2, 3, 4] }
  expect(grabWeights(line, 1, 10)).toEqual([0.5, 1, 0.5, 0, 0])
  expect(grabWeights(line, 1, 10, [0])).toEqual([0, 1, 0.5, 0, 0])
})
