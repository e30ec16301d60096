import { describe, expect, it } from 'vitest'
import { acrossLine, DepthDrag } from '../../../../studio/src/lines/depth-drag.ts'

const START = { x: 100, y: 100 }
const DOWN = [0, 1] as const

describe('a drag across a line', () => {
  it('deepens the line downwards and flattens it upwards, after a few pixels', () => {
    const drag = new DepthDrag(START, 0.5, DOWN)
    expect(drag.to({ x: 100, y: 103 })).toBeUndefined()
    expect(drag.to({ x: 160, y: 150 })).toBe(1)
    expect(drag.to({ x: 100, y: 80 })).toBe(0.3)
    expect(drag.to({ x: 100, y: 0 })).toBe(0)
    expect(drag.to({ x: 100, y: 900 })).toBe(3)
  })

  it('raises a bulge instead', () => {
    expect(new DepthDrag(START, -0.5, DOWN).to({ x: 100, y: 150 })).toBe(-1)
  })
})

it('deepening is downwards, or to the right of an upright line', () => {
  const line = (x: number[], y: number[]) => ({
    x: Float32Array.from(x),
    y: Float32Array.from(y),
    along: Float64Array.of(0, 1),
  })
  expect(acrossLine(line([0, 10], [0, 0]), 0.5)).toEqual([-0, 1])
  expect(acrossLine(line([10, 0], [0, 0]), 0.5)).toEqual([0, 1])
  expect(acrossLine(line([0, 0], [10, 0]), 0.5)).toEqual([1, 0])
})
