import { expect, it } from 'vitest'
import { acrossOf, unroll } from '../../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { seeded } from '../../../random.ts'

it('acrossOf contains all points of a box, and no more than it must', () => {
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

it('acrossOf leaves nothing out behind the axis of the head', () => {
  expect(acrossOf([-10, 0, -90], [10, 0, -80])).toEqual([-Infinity, Infinity])
})
