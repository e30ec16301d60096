// Reads and writes the table of browsers in README.md.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { writeTable } from './marked-table.mjs'
import { ROOT } from './run.mjs'

const MEASURED = join(ROOT, 'docs', 'browsers.json')

const TITLES = { chromium: 'Chromium', firefox: 'Firefox ESR', webkit: 'WebKitGTK' }

/** Column title per capability, and the text of a cell if a browser lacks the capability. */
const COLUMNS = {
  webgl2: ['WebGL 2', 'no: faces are not drawn'],
  webgpu: ['WebGPU', 'no: `WebGPURenderer` draws with WebGL 2'],
  auto: ['automatic wrinkles in the page', 'no: faces stay plain'],
  studio: ['studio', 'in part'],
}

/**
 * Returns the version and capabilities of each browser.
 *
 * @param report JSON report of Vitest for `test/browsers/capabilities.test.ts`.
 */
export function readReport(report) {
  const tests = report.testResults.flatMap((file) => file.assertionResults)
  return Object.fromEntries(
    Object.keys(TITLES).map((name) => {
      const measuring = tests.filter(({ ancestorTitles: [suite] }) => suite === `in ${name}`)
      const { version, ...found } = Object.assign({}, ...measuring.map(({ meta }) => meta.browser))
      const { webgl2 = false, webgpu = false, auto = false, studio = false } = found
      return [name, { version: version.split('.').slice(0, 2).join('.'), webgl2, webgpu, auto, studio }]
    }),
  )
}

export function browserTable(measured) {
  const columns = Object.values(COLUMNS)
  const rows = Object.entries(measured).map(([name, found]) => {
    const cells = Object.entries(COLUMNS).map(([key, [, missing]]) => (found[key] ? 'yes' : missing))
    return `| ${TITLES[name]} ${found.version} | ${cells.join(' | ')} |`
  })
  return [
    `| browser | ${columns.map(([title]) => title).join(' | ')} |`,
    `| --- |${' --- |'.repeat(columns.length)}`,
    ...rows,
  ]
}

export const readMeasured = () => JSON.parse(readFileSync(MEASURED, 'utf8'))

/** Stores the capabilities in docs/browsers.json, and updates the table in README.md. */
export function writeBrowsers(measured) {
  writeFileSync(MEASURED, `${JSON.stringify(measured, null, 2)}\n`)
  writeTable('README.md', 'browsers', browserTable(measured))
}
