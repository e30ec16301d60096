import type { Curve } from 'furrow'
import { curveAt } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import {
  addPoint,
  movePoint,
  rangeAround,
  removePoint,
  stepOf,
  widestGap,
} from '../../../studio/src/document/curve.ts'
import { ramp } from '../../drivers.ts'
import { seeded } from '../../random.ts'

const UNIT = { input: [0, 1], output: [0, 1] } as const
const line: Curve = [
  [0, 0],
  [0.5, 0.2],
  [1, 1],
]

describe('the step of a range', () => {
  it.each([
    [[0, 1], 0.01],
    [[20, 80], 0.5],
    [[0, 0.5], 0.005],
    [[0, 500], 5],
    [[-0.3, 1.3], 0.01],
    [[0, Math.PI], 0.02],
  ] as const)('of %j is %d', (range, step) => {
    expect(stepOf(range)).toBeCloseTo(step, 10)
  })
})

describe('a moved point', () => {
  it('moves in steps', () => {
    expect(movePoint(line, 1, [0.3333, 0.6666], UNIT)[1]).toEqual([0.33, 0.67])
  })

  it('stays between its neighbour points', () => {
    expect(movePoint(line, 1, [2, 0.2], UNIT)[1]).toEqual([0.99, 0.2])
    expect(movePoint(line, 1, [-2, 0.2], UNIT)[1]).toEqual([0.01, 0.2])
    expect(movePoint(line, 0, [0.9, 0], UNIT)[0]).toEqual([0.49, 0])
  })

  it('stays within the ranges of inputs and outputs', () => {
    expect(movePoint(line, 0, [-1, -1], UNIT)[0]).toEqual([0, 0])
    expect(movePoint(line, 2, [3, 3], UNIT)[2]).toEqual([1, 1])
  })

  it('keeps its input if there is no step between its neighbours', () => {
    const narrow: Curve = [
      [0.5, 0],
      [0.505, 0.5],
      [0.51, 1],
    ]
    expect(movePoint(narrow, 1, [0.9, 0.1], UNIT)[1]).toEqual([0.505, 0.1])
  })

  it('does not modify the old curve, and keeps the other points', () => {
    const moved = movePoint(line, 1, [0.4, 0.4], UNIT)
    expect(moved).not.toBe(line)
    expect(moved[0]).toBe(line[0])
    expect(moved[2]).toBe(line[2])
    expect(line[1]).toEqual([0.5, 0.2])
  })

  it('leaves the inputs of the curve strictly increasing, wherever it is dragged', () => {
    const random = seeded(1)
    let curve = line
    for (let i = 0; i < 500; i++) {
      const index = Math.floor(random() * curve.length)
      if (random() < 0.05 && curve.length < 12) curve = addPoint(curve, random(), UNIT)
      else if (random() < 0.03) curve = removePoint(curve, index)
      else curve = movePoint(curve, index, [3 * random() - 1, 3 * random() - 1], UNIT)
      for (let k = 1; k < curve.length; k++) expect(curve[k][0]).toBeGreaterThan(curve[k - 1][0])
      for (const [, output] of curve) expect(output >= 0 && output <= 1).toBe(true)
    }
  })
})

describe('an added point', () => {
  it('lies on the curve and does not change its shape', () => {
    const more = addPoint(line, 0.75, UNIT)
    expect(more).toHaveLength(4)
    expect(more[2]).toEqual([0.75, 0.6])
    for (const input of [0, 0.2, 0.6, 0.9]) expect(curveAt(more, input)).toBeCloseTo(curveAt(line, input), 10)
  })

  it('is not added at an existing point', () => {
    expect(addPoint(line, 0.502, UNIT)).toEqual(line)
  })

  it('is added in the middle of the widest gap', () => {
    const uneven: Curve = [
      [0, 0],
      [0.2, 0.1],
      [1, 1],
    ]
    expect(widestGap(uneven)).toBeCloseTo(0.6, 10)
  })
})

it('the last two points cannot be removed', () => {
  const two = removePoint(line, 1)
  expect(two).toEqual([line[0], line[2]])
  expect(removePoint(two, 0)).toEqual(two)
})

describe('the displayed range of a curve', () => {
  it('is the default range if the curve fits in it', () => {
    expect(rangeAround(line, [0, 1])).toEqual([0, 1])
  })

  it('is otherwise the range of the curve with a margin at both ends', () => {
    const loudness: Curve = ramp(60, 95)
    const [low, high] = rangeAround(loudness)
    expect(low).toBeLessThan(60)
    expect(high).toBeGreaterThan(95)
    expect(rangeAround([[0, 0], ...loudness], [0, 1])[1]).toBeGreaterThan(95)
  })
})
