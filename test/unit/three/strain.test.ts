import { strainColour, strainOf } from 'furrow/internal/three'
import { expect, it } from 'vitest'

/** Square of two triangles, and a third one without area. */
const SQUARE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]
const INDICES = [0, 1, 2, 0, 2, 3, 1, 1, 2]
const posed = (move: (x: number, y: number) => number[]) =>
  [0, 3, 6, 9].flatMap((i) => move(SQUARE[i], SQUARE[i + 1]))

it.each([
  ['rests', (x: number, y: number) => [x, y, 0], 0],
  ['is moved and turned', (x: number, y: number) => [5 - y, 3, x], 0],
  ['is compressed', (x: number, y: number) => [0.8 * x, y, 0], -0.2],
  ['is stretched', (x: number, y: number) => [x, 1.1 * y, 0], 0.1],
  ['is more compressed than stretched', (x: number, y: number) => [0.7 * x, 1.2 * y, 0], -0.3],
])('has the strain of skin that %s', (_, move, strain) => {
  for (const value of strainOf(SQUARE, posed(move), INDICES)) expect(value).toBeCloseTo(strain, 6)
})

it('has no strain at a vertex without triangles', () => {
  expect([...strainOf([...SQUARE, 9, 9, 9], [...SQUARE, 8, 8, 8], INDICES)].at(-1)).toBe(0)
})

it('shows compressed skin in orange and stretched skin in blue, also at extreme strains', () => {
  const [r, , b] = strainColour(-9)
  expect(r).toBeGreaterThan(3 * b)
  const [red, , blue] = strainColour(0.3)
  expect(blue).toBeGreaterThan(3 * red)
  expect(strainColour(9)).toEqual(strainColour(0.3))
})
