import { expect, it } from 'vitest'
import type { Result } from '../../../bench/report.ts'
import { extraCosts } from '../../../site/benchmark/extra-costs.ts'

const setup = { width: 1280, height: 720, timing: 'timestamps', spreadMs: 0, ratioToPaper: null } as const
const benchCase = { areas: 8, active: 8, layers: 1, maps: 'normals', still: false } as const

function resultOf(variant: string, ratioToPlain: number, changes: Partial<Result> = {}): Result {
  return {
    ...setup,
    ...benchCase,
    variant,
    ratioToPlain,
    renderer: 'webgl',
    adapter: 'a',
    medianMs: 3,
    ...changes,
  }
}

it('are those of moving areas, by renderer, with bars relative to the longest', () => {
  const webgpu = { renderer: 'webgpu', adapter: 'b' } as const
  const charts = extraCosts([
    resultOf('plain', 1),
    resultOf('furrow', 1.25),
    resultOf('furrow', 1.4, { maps: 'all' }),
    resultOf('furrow', 9, { still: true }),
    resultOf('plain', 1, { ...webgpu, medianMs: 4 }),
    resultOf('auto', 1.5, webgpu),
  ])
  expect(charts).toEqual([
    {
      renderer: 'WebGL 2',
      adapter: 'a',
      plainMs: 3,
      bars: [
        { name: 'furrow', extra: expect.closeTo(0.25), length: expect.closeTo(0.5) },
        { name: 'furrow, all maps', extra: expect.closeTo(0.4), length: expect.closeTo(0.8) },
      ],
    },
    {
      renderer: 'WebGPU',
      adapter: 'b',
      plainMs: 4,
      bars: [{ name: 'auto', extra: expect.closeTo(0.5), length: 1 }],
    },
  ])
})

it('have no bar if noise made the measurement with wrinkles faster', () => {
  const [{ bars }] = extraCosts([resultOf('plain', 1), resultOf('auto', 0.9), resultOf('furrow', 1.1)])
  expect(bars.map(({ length }) => length)).toEqual([0, 1])
})
