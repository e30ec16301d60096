import { describe, expect, test } from 'vitest'
import { FaceRng } from '../../../../packages/furrow/src/author/auto/anatomy/face-rng.ts'

const COUNT = 2000
const SYMMETRIES = [0, 0.1, 0.5, 0.8, 1]

const indices = Array.from({ length: COUNT }, (_, i) => i)

function draw(name: string, symmetry: number): number[] {
  const rng = FaceRng.of(5, name, symmetry)
  return indices.map(() => rng.uniform(0, 1))
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

/** Returns the correlation of two lists with the same mean. */
function correlation(a: readonly number[], b: readonly number[]): number {
  const middle = mean(a)
  const product = (x: readonly number[], y: readonly number[]) =>
    mean(x.map((value, i) => (value - middle) * (y[i] - middle)))
  return product(a, b) / Math.sqrt(product(a, a) * product(b, b))
}

describe('random numbers of a part on the right', () => {
  test('are those of the left at symmetry 1, and differ at 0', () => {
    expect(draw('noseRight', 1)).toEqual(draw('noseLeft', 0))
    expect(Math.abs(correlation(draw('noseRight', 0), draw('noseLeft', 0)))).toBeLessThan(0.1)
  })

  test('become more like those of the left with more symmetry', () => {
    const left = draw('noseLeft', 0)
    const all = SYMMETRIES.map((symmetry) => correlation(draw('noseRight', symmetry), left))
    for (const [i, value] of all.entries()) if (i > 0) expect(value).toBeGreaterThan(all[i - 1])
  })

  test.each(SYMMETRIES)('are uniformly distributed at symmetry %s', (symmetry) => {
    const sorted = draw('noseRight', symmetry).sort((a, b) => a - b)
    const distances = sorted.map((value, i) => Math.abs(value - (i + 0.5) / COUNT))
    expect(Math.max(...distances)).toBeLessThan(0.04)
  })
})

test('numbers on the left do not depend on symmetry', () => {
  expect(draw('noseLeft', 0.7)).toEqual(draw('noseLeft', 0))
})

describe('lines of a part that crosses the middle', () => {
  const lines = (count: number, symmetry: number) =>
    FaceRng.of(5, 'lip', symmetry).row(count, (rng) => ({ across: rng.across(2), depth: rng.uniform(0, 1) }))

  test.each([4, 5])('are mirrored at symmetry 1, %d lines', (count) => {
    const mirrored = lines(count, 1).reverse()
    for (const [i, { across, depth }] of lines(count, 1).entries()) {
      expect(across).toBeCloseTo(-mirrored[i].across, 12)
      expect(depth).toBe(mirrored[i].depth)
    }
  })

  test('are drawn one after the other at symmetry 0', () => {
    const rng = FaceRng.of(5, 'lip', 0)
    const expected = Array.from({ length: 4 }, () => ({ across: rng.across(2), depth: rng.uniform(0, 1) }))
    expect(lines(4, 0)).toEqual(expected)
  })

  test('leave the generator after the last line', () => {
    const [rng, other] = [FaceRng.of(5, 'lip', 1), FaceRng.of(5, 'lip', 0)]
    rng.row(3, (rng) => rng.uniform(0, 1))
    for (let i = 0; i < 3; i++) other.uniform(0, 1)
    expect(rng.uniform(0, 1)).toBe(other.uniform(0, 1))
  })
})

describe('noise of a film', () => {
  const fieldOf = (name: string, symmetry: number) => {
    const noise = FaceRng.of(5, name, symmetry).film()
    // Samples are farther apart than bumps, so that they are independent.
    return (side: 1 | -1) =>
      indices.map((i) => noise(side * (1 + (i % 50) * 6), Math.floor(i / 50) * 6, 1.5, 2))
  }
  const deviation = (values: readonly number[]) => Math.sqrt(mean(values.map((value) => value * value)))

  test('mirrors the left side at symmetry 1', () => {
    expect(fieldOf('noseRight', 1)(-1)).toEqual(fieldOf('noseLeft', 0)(1))
    expect(fieldOf('forehead', 1)(-1)).toEqual(fieldOf('forehead', 0)(1))
  })

  test.each(SYMMETRIES)('has the same variance at symmetry %s', (symmetry) => {
    const plain = deviation(fieldOf('noseLeft', 0)(1))
    for (const name of ['noseRight', 'forehead'])
      expect(deviation(fieldOf(name, symmetry)(-1)) / plain).toBeCloseTo(1, 1)
  })

  test('has the same variance near the middle, and no step there', () => {
    const noise = FaceRng.of(5, 'forehead', 0.5).film()
    const column = (x: number) => indices.map((i) => noise(x, 6 * i, 1.5, 2))
    for (const x of [-0.3, -0.8, -1.5]) expect(deviation(column(x))).toBeCloseTo(deviation(column(1)), 1)
    const [right, left] = [column(-1e-6), column(1e-6)]
    expect(Math.max(...right.map((value, i) => Math.abs(value - left[i])))).toBeLessThan(1e-4)
  })
})
