import { expect, it } from 'vitest'
import { browserTable, readMeasured, readTable } from '../../scripts/lib/browser-table.mjs'

it("README's table of browsers is what was measured", () => {
  const measured = readMeasured()
  expect(Object.keys(measured)).toEqual(['chromium', 'firefox', 'webkit'])
  expect(readTable()).toBe(browserTable(measured))
})

it('a browser that lacks something says so', () => {
  const found = { version: '1.2', webgl2: true, webgpu: false, auto: false, studio: true }
  expect(browserTable({ firefox: found })).toContain('| Firefox ESR 1.2 | yes | no: ')
})
