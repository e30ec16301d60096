import { expect, it } from 'vitest'
import { browserTable, readMeasured } from '../../scripts/lib/browser-table.mjs'
import { readTable } from '../../scripts/lib/marked-table.mjs'

it('the table of browsers in README.md equals the measurements', () => {
  const measured = readMeasured()
  expect(Object.keys(measured)).toEqual(['chromium', 'firefox', 'webkit'])
  expect(readTable('README.md', 'browsers')).toEqual(browserTable(measured))
})

it('a browser with missing features says so', () => {
  const found = { version: '1.2', webgl2: true, webgpu: false, auto: false, studio: true }
  expect(browserTable({ firefox: found })).toContainEqual(
    expect.stringContaining('| Firefox ESR 1.2 | yes | no: '),
  )
})
