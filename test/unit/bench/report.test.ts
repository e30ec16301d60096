import { describe, expect, it } from 'vitest'
import { type Measured, toResults, toTable } from '../../../bench/report.ts'

const benchCase = { areas: 8, active: 8, layers: 1, maps: 'normals', still: false } as const
const setup = {
  width: 800,
  height: 600,
  renderer: 'webgl',
  adapter: 'an adapter',
  timing: 'fence',
} as const
const measured: Measured[] = [
  { variant: 'plain', rounds: [10, 20, 12], changed: 0 },
  { variant: 'paper', rounds: [20, 40, 24], changed: 0.3 },
  { variant: 'furrow', rounds: [11, 22, 18], changed: 0.3 },
]

describe('bench results', () => {
  it('contain the case, the setup, and ratios by round', () => {
    const results = toResults(benchCase, setup, measured)
    expect(results[2]).toEqual({
      variant: 'furrow',
      ...benchCase,
      ...setup,
      medianMs: 18,
      spreadMs: 5.5,
      ratioToPlain: 1.1,
      ratioToPaper: 0.55,
    })
    expect(results[0].ratioToPlain).toBe(1)
  })

  it("have no ratio to the paper's material if it cannot draw the case", () => {
    const [plain, , furrow] = measured
    expect(toResults(benchCase, setup, [plain, furrow]).map(({ ratioToPaper }) => ratioToPaper)).toEqual([
      null,
      null,
    ])
  })

  it('require a measurement of the face without wrinkles', () => {
    expect(() => toResults(benchCase, setup, measured.slice(1))).toThrow('"plain" was not measured')
  })
})

describe('bench table', () => {
  it('has a row per result, and columns of equal width', () => {
    const lines = toTable(toResults(benchCase, setup, measured)).split('\n')
    expect(lines).toHaveLength(5)
    expect(new Set(lines.map(({ length }) => length)).size).toBe(1)
    const cells = lines[4]
      .split('|')
      .slice(1, -1)
      .map((cell) => cell.trim())
    expect(cells).toEqual([
      'webgl',
      '1',
      'normals',
      '8',
      '8',
      'yes',
      'furrow',
      '18.00',
      '5.50',
      '1.100',
      '0.550',
    ])
  })
})
