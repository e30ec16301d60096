import { expect, test } from 'vitest'
import { bankReaches } from '../../../../packages/furrow/src/author/auto/lines/bank-reaches.ts'
import type { SkinLine } from '../../../../packages/furrow/src/author/strokes/curve.ts'
import { bankAt, bankSlope } from '../../../../packages/furrow/src/author/strokes/profile.ts'

/** Returns a wrinkle line, 40 mm long, along x on skin that faces +z. Banks are the raised skin on both sides of a line. */
function lineAt(y: number): SkinLine {
  const points = Float64Array.from({ length: 3 * 41 }, (_, i) => [Math.floor(i / 3), y, 0][i % 3])
  const normals = Float64Array.from({ length: 3 * 41 }, (_, i) => [0, 0, 1][i % 3])
  return { points, normals }
}

const SPACING = 6
const lines = [lineAt(0), lineAt(3), lineAt(6)]

test('banks end at the next line', () => {
  const [lowest, middle, highest] = bankReaches(lines, [1, 1, 1], SPACING)
  // The line runs along +x, so +y is on its left.
  expect(lowest[0]).toBeCloseTo(3)
  expect(middle).toEqual([3, 3])
  expect(highest[1]).toBeCloseTo(3)
})

test('banks of two lines continue under a line between them that is less than half as deep', () => {
  const [lowest, middle, highest] = bankReaches(lines, [1, 0.35, 0.8], SPACING)
  expect(lowest[0]).toBeCloseTo(6)
  expect(middle).toEqual([3, 3])
  expect(highest[1]).toBeCloseTo(6)
})

test('the number of comparisons per line does not grow with the number of lines', () => {
  const comparedPerLine = (count: number) => {
    let compared = 0
    const depths = new Proxy(new Array<number>(count).fill(1), {
      get: (list, key: `${number}`) => {
        compared++
        return list[Number(key)]
      },
    })
    const many = Array.from({ length: count }, (_, i) => lineAt(SPACING * i))
    bankReaches(many, depths, SPACING)
    return compared / count
  }
  expect(comparedPerLine(160) / comparedPerLine(40)).toBeLessThan(1.2)
})

test('the slope of a bank matches its profile', () => {
  const [depth, halfWidth, reach] = [0.8, 0.9, 3.1]
  const height = (distance: number) => depth * bankAt(distance / halfWidth, reach / halfWidth, 1)
  const step = 1e-4
  let steepest = 0
  for (let distance = reach / 3; distance < reach; distance += 0.001) {
    steepest = Math.max(steepest, (height(distance) - height(distance + step)) / step)
  }
  expect(bankSlope(depth, halfWidth, reach)).toBeCloseTo(steepest, 3)
})
