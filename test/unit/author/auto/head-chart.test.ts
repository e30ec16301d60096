import { expect, it } from 'vitest'
import {
  acrossOf,
  HeadChart,
  unroll,
} from '../../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { weldSurface } from '../../../../packages/furrow/src/author/skin/surface.ts'
import { seeded } from '../../../random.ts'

it('acrossOf returns the smallest range of unrolled x that contains a box', () => {
  const next = seeded(1)
  for (let round = 0; round < 500; round++) {
    const low = [180 * next() - 90, 0, 160 * next() - 80]
    const high = low.map((value) => value + 20 * next())
    const [left, right] = acrossOf(low, high)
    const corners = [low[0], high[0]].flatMap((x) => [low[2], high[2]].map((z) => unroll(x, 0, z)[0]))
    expect([left, right]).toEqual([Math.min(...corners), Math.max(...corners)])
    for (let i = 0; i < 10; i++) {
      const [x, z] = [0, 2].map((k) => low[k] + next() * (high[k] - low[k]))
      const [across] = unroll(x, 0, z)
      expect(across >= left && across <= right).toBe(true)
    }
  }
})

it('acrossOf returns an infinite range for a box behind the axis of the head', () => {
  expect(acrossOf([-10, 0, -90], [10, 0, -80])).toEqual([-Infinity, Infinity])
})

it.each([
  ['the skin below a smaller surface that is close to it, like brows', 3, 0],
  ['the outermost surface where it is far from the skin', 30, 30],
])('finds %s', (_, gap, z) => {
  const quad = (side: number, z: number) =>
    [-1, 1].flatMap((y) => [-1, 1].flatMap((x) => [side * x, side * y, z]))
  const skin = [0, 1, 2, 1, 3, 2]
  const piece = skin.map((corner) => corner + 4)
  const positions = [...quad(40, 0), ...quad(10, gap)]
  for (const indices of [
    [...skin, ...piece],
    [...piece, ...skin],
  ]) {
    const chart = new HeadChart(weldSurface({ positions, indices }))
    expect(chart.find([1, 2])!.position[2]).toBeCloseTo(z, 6)
  }
})
