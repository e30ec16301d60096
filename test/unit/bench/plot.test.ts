import { expect, it } from 'vitest'
import { toPlot } from '../../../bench/plot.ts'
import type { Result } from '../../../bench/report.ts'

const result = (
  variant: string,
  areas: number,
  ratioToPlain: number,
  overrides: Partial<Result> = {},
): Result => ({
  variant,
  areas,
  active: areas,
  layers: 1,
  maps: 'normals' as const,
  still: false,
  width: 800,
  height: 600,
  renderer: 'webgl',
  adapter: 'A <fast> one',
  timing: 'fence',
  medianMs: 1,
  spreadMs: 0,
  ratioToPlain,
  ratioToPaper: null,
  ...overrides,
})

it('draws a line per variant, higher where it is slower, and omits other cases', () => {
  const svg = toPlot([
    result('plain', 2, 1),
    result('plain', 256, 1),
    result('furrow', 2, 1.1),
    result('furrow', 256, 1.1),
    result('paper', 2, 1.5),
    result('paper', 256, 8),
    result('paper', 64, 99, { still: true }),
    result('o3de', 2, 99, { layers: 4 }),
  ])
  const lines = [...svg.matchAll(/points="([^"]+)"/g)].map(([, points]) =>
    points.split(' ').map((point) => point.split(',').map(Number)),
  )
  expect(lines).toHaveLength(3)
  const [plain, furrow, paper] = lines
  expect(plain[0][1]).toBe(plain[1][1])
  expect(furrow[0][1]).toBeLessThan(plain[0][1])
  expect(paper[1][1]).toBeLessThan(paper[0][1])
  expect(Math.min(...lines.flat().map(([, y]) => y))).toBeGreaterThan(40)
  expect(paper[0][0]).toBeLessThan(paper[1][0])
  expect(svg).toContain('A &lt;fast> one')
  expect(svg).not.toContain('>o3de<')
})
