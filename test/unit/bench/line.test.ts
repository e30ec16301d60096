import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { LINE_HEADING, LINE_VARIANTS, toLine } from '../../../bench/line.ts'
import type { Result } from '../../../bench/report.ts'

const machine = { browser: 'Browser 1.0, system 2', date: new Date('2026-11-26T23:59:00Z') }

function resultOf(changes: Partial<Result>): Result {
  return {
    variant: 'plain',
    renderer: 'webgl',
    adapter: 'GL',
    timing: 'timestamps',
    width: 800,
    height: 600,
    areas: 8,
    active: 8,
    layers: 1,
    maps: 'normals',
    still: false,
    medianMs: 1.234,
    spreadMs: 0,
    ratioToPlain: 1,
    ratioToPaper: null,
    ...changes,
  }
}

/** Returns the cells of a table row by column title. */
function read(line: string): Record<string, string> {
  const [titles, , cells] = [...LINE_HEADING.split('\n'), line].map((row) =>
    row
      .split(/(?<!\\)\|/)
      .slice(1, -1)
      .map((cell) => cell.trim()),
  )
  expect(cells).toHaveLength(titles.length)
  return Object.fromEntries(titles.map((title, i) => [title, cells[i]]))
}

it('has a value per renderer, moving and still', () => {
  const results = [
    resultOf({}),
    resultOf({ renderer: 'webgpu', adapter: 'GPU', medianMs: 2, timing: 'fence' }),
    resultOf({ variant: 'furrow', ratioToPlain: 1.0471 }),
    resultOf({ variant: 'furrow', still: true, ratioToPlain: 1.044 }),
    resultOf({ variant: 'furrow', renderer: 'webgpu', ratioToPlain: 1.037 }),
    resultOf({ variant: 'furrow', maps: 'all', ratioToPlain: 1.1 }),
  ]
  expect(read(toLine(results, machine))).toMatchObject({
    date: '2026-11-26',
    adapter: 'GL; GPU',
    browser: 'Browser 1.0, system 2',
    picture: '800 x 600',
    'timed by': 'timestamps; fence',
    'plain, ms': '1.23; 2.00',
    furrow: '1.047, 1.044; 1.037, -',
    'all maps: furrow': '1.100, -; -, -',
    jimenez: '-, -; -, -',
    versions: expect.stringMatching(/^furrow \d+\.\d+\.\d+, three\.js r\d+$/),
  })
})

it('contains only results with 8 areas and one layer', () => {
  const others = [{ areas: 16, active: 16 }, { layers: 4 }, { areas: 256 }]
  const results = [...others, {}].map((changes, i) =>
    resultOf({ variant: 'furrow', ratioToPlain: 1 + i, ...changes }),
  )
  expect(read(toLine(results, machine)).furrow).toBe('4.000, -; -, -')
})

it('is one row, whatever characters the name of the adapter has', () => {
  const line = toLine([resultOf({ adapter: 'a | b\n  c' })], machine)
  expect(line).not.toContain('\n')
  expect(read(line).adapter).toBe('a \\| b c')
})

it('uses the expected variants', () => {
  expect([...LINE_VARIANTS].sort().join(' ')).toBe('furrow jimenez o3de plain stripped')
})

it('has the format of the rows in bench/machines.md', () => {
  const text = readFileSync(new URL('../../../bench/machines.md', import.meta.url), 'utf8')
  const [, rows] = text.split(`${LINE_HEADING}\n`)
  for (const row of rows.trim().split('\n'))
    expect(read(row)).toMatchObject({
      date: expect.stringMatching(/^\d{4}-\d\d-\d\d$/),
      furrow: expect.stringMatching(/^(\S+, \S+; )\S+, \S+$/),
    })
})
