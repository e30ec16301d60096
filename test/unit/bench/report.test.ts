import { describe, expect, it } from 'vitest'
import { type Measured, toResults, toTable } from '../../../bench/report.ts'

const shown = { areas: 8, active: 8, layers: 1, still: false }
const setting = {
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
  it('hold the case, the setting, and ratios round by round', () => {
    const results = toResults(shown, setting, measured)
    expect(results[2]).toEqual({
      variant: 'furrow',
      ...shown,
      ...setting,
      medianMs: 18,
      spreadMs: 5.5,
      ratioToPlain: 1.1,
      ratioToPaper: 0.55,
    })
    expect(results[0].ratioToPlain).toBe(1)
  })

  it('have no ratio to the paper where it cannot show the case', () => {
    const [plain, , furrow] = measured
    expect(toResults(shown, setting, [plain, furrow]).map(({ ratioToPaper }) => ratioToPaper)).toEqual([
      null,
      null,
    ])
  })

  it('need the plain face', () => {
    expect(() => toResults(shown, setting, measured.slice(1))).toThrow('"plain" was not measured')
  })
})

describe('bench table', () => {
  it('has a row for each result, all cells of a column equally wide', () => {
    const lines = toTable(toResults(shown, setting, measured)).split('\n')
    expect(lines).toHaveLength(5)
    expect(new Set(lines.map(({ length }) => length)).size).toBe(1)
    const cells = lines[4]
      .split('|')
      .slice(1, -1)
      .map((cell) => cell.trim())
    expect(cells).toEqual(['webgl', '1', '8', '8', 'yes', 'furrow', '18.00', '5.50', '1.100', '0.550'])
  })
})
