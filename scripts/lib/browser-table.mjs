// The table of browsers in README.md: what tests found in each.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { writeTable } from './marked-table.mjs'
import { ROOT } from './run.mjs'

const MEASURED = join(ROOT, 'docs', 'browsers.json')

const TITLES = { chromium: 'Chromium', firefox: 'Firefox ESR', webkit: 'WebKitGTK' }

/** Columns by what was measured, with the words for what a browser lacks. */
const COLUMNS = {
  webgl2: ['WebGL 2', 'no: faces are not drawn'],
  webgpu: ['WebGPU', 'no: `WebGPURenderer` draws with WebGL 2'],
  auto: ['automatic wrinkles in the page', 'no: faces stay plain'],
  studio: ['studio', 'in part'],
}

/**
 * @param report JSON of Vitest for `test/browsers/capabilities.test.ts`.
 * @returns what was found in each browser.
 */
export function measuredOf(report) {
  const tests = report.testResults.flatMap((file) => file.assertionResults)
  return Object.fromEntries(
    Object.keys(TITLES).map((name) => {
      const own = tests.filter(({ ancestorTitles: [suite] }) => suite === `in ${name}`)
      const { version, ...found } = Object.assign({}, ...own.map(({ meta }) => meta.browser))
      const { webgl2 = false, webgpu = false, auto = false, studio = false } = found
      return [name, { version: version.split('.').slice(0, 2).join('.'), webgl2, webgpu, auto, studio }]
    }),
  )
}

/** The lines of the table of what was measured. */
export function browserTable(measured) {
  const columns = Object.values(COLUMNS)
  const rows = Object.entries(measured).map(([name, found]) => {
    const cells = Object.entries(COLUMNS).map(([key, [, lacking]]) => (found[key] ? 'yes' : lacking))
    return `| ${TITLES[name]} ${found.version} | ${cells.join(' | ')} |`
  })
  return [
    `| browser | ${columns.map(([title]) => title).join(' | ')} |`,
    `| --- |${' --- |'.repeat(columns.length)}`,
    ...rows,
  ]
}

export const readMeasured = () => JSON.parse(readFileSync(MEASURED, 'utf8'))

/** Keeps what was measured, and writes the table into the page. */
export function writeBrowsers(measured) {
  writeFileSync(MEASURED, `${JSON.stringify(measured, null, 2)}\n`)
  writeTable('README.md', 'browsers', browserTable(measured))
}
