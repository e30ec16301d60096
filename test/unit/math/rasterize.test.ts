import { describe, expect, it } from 'vitest'
import { barycentrics2 } from '../../../packages/furrow/src/math/barycentrics.ts'
import { rasterize } from '../../../packages/furrow/src/math/rasterize.ts'
import { seeded } from '../../random.ts'
import { across } from '../../strokes.ts'

/** Returns the pixels that a triangle covers as [column, row, a, b, c], with barycentric coordinates a, b and c. */
function covered(triangle: number[], ...rest: [tolerance?: number, box?: [number, number, number, number]]) {
  const pixels: number[][] = []
  rasterize(triangle, rest[0] ?? 1e-6, (...pixel) => pixels.push(pixel), rest[1])
  return pixels
}

const pixelsOf = (pixels: number[][]) => pixels.map(([column, row]) => [column, row])

describe('rasterize', () => {
  it('visits the pixels whose centres are inside, row by row, for both orientations', () => {
    const expected = [
      [0, 0],
      [1, 0],
      [2, 0],
      [0, 1],
      [1, 1],
      [0, 2],
    ]
    expect(pixelsOf(covered([0, 0, 2, 0, 0, 2]))).toEqual(expected)
    expect(pixelsOf(covered([0, 0, 0, 2, 2, 0]))).toEqual(expected)
  })

  it('passes barycentric coordinates in the order of the corners', () => {
    expect(covered([0, 0, 4, 0, 0, 2]).find(([x, y]) => x === 1 && y === 1)).toEqual([1, 1, 0.25, 0.25, 0.5])
  })

  it('passes the same coordinates as barycentrics2, bit for bit', () => {
    const random = seeded(5)
    const weights = new Float64Array(3)
    for (let i = 0; i < 50; i++) {
      const triangle = Array.from({ length: 6 }, () => 20 * random() - 4)
      for (const [column, row, ...coordinates] of covered(triangle)) {
        barycentrics2(weights, triangle, column, row)
        expect(coordinates).toEqual([...weights])
      }
    }
  })

  it('visits negative pixels, but none beyond the box', () => {
    const triangle = [-2, -2, 4, -2, -2, 4]
    expect(pixelsOf(covered(triangle))).toContainEqual([-2, -2])
    expect(pixelsOf(covered(triangle, 1e-6, [0, 0, 1, 0]))).toEqual(across(0, 0, 1))
  })

  it('also visits pixels whose centres are outside by less than the tolerance', () => {
    const triangle = [0, 0, 1.99, 0, 0, 1.99]
    expect(pixelsOf(covered(triangle, 0))).not.toContainEqual([1, 1])
    expect(pixelsOf(covered(triangle, 0.01))).toContainEqual([1, 1])
  })

  it('visits nothing for a triangle that has no area or covers no pixel centre', () => {
    expect(covered([0, 0, 3, 3, 6, 6])).toEqual([])
    expect(covered([0.2, 0.2, 0.8, 0.2, 0.2, 0.8])).toEqual([])
  })
})
