import { expect, it } from 'vitest'
import { countForeheadLines } from '../../../bench/auto/identities/forehead.ts'
import { lineSpacing } from '../../../bench/auto/identities/line-spacing.ts'
import type { LineSample, SkinLine } from '../../../bench/auto/identities/skin-lines.ts'

/** Returns a horizontal line at a height, from x = `from` to x = `to`, on skin that faces +z. Lengths are in millimetres. */
function horizontal(y: number, from: number, to: number): SkinLine {
  const samples = Array.from(
    { length: 2 * (to - from) + 1 },
    (_, i): LineSample => ({
      uv: [0, 0],
      position: [from + i / 2, y, 0],
      normal: [0, 0, 3],
    }),
  )
  return { region: 'forehead', length: to - from, samples }
}

it('measures the distance between neighbours, not between ends or distant lines', () => {
  const full = [0, 10, 20].map((y) => horizontal(y, -40, 40))
  expect(lineSpacing(full, 12)).toBeCloseTo(10)
  expect(lineSpacing([...full, horizontal(200, -40, 40)], 12)).toBeCloseTo(10)
  expect(lineSpacing([horizontal(0, -40, 0), horizontal(0, 3, 40)], 12)).toBeUndefined()
})

it('counts two halves of a forehead line as one', () => {
  const lines = [
    horizontal(0, -50, 50),
    horizontal(10, -50, 50),
    horizontal(20, -50, 2),
    horizontal(21, 3, 50),
  ]
  expect(countForeheadLines(lines)).toBe(3)
})
