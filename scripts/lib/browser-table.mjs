// The table of browsers in README.md: what tests found in each.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from './run.mjs'

const PAGE = join(ROOT, 'README.md')
const MEASURED = join(ROOT, 'docs', 'browsers.json')
const MARKS = ['<!-- browsers -->', '<!-- end of browsers -->']

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

/** The table of what was measured. */
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
  ].join('\n')
}

export const readMeasured = () => JSON.parse(readFileSync(MEASURED, 'utf8'))

/** The table that the page has. */
export const readTable = () => readFileSync(PAGE, 'utf8').split(MARKS[0])[1].split(MARKS[1])[0].trim()

/** Keeps what was measured, and writes the table into the page. */
export function writeBrowsers(measured) {
  writeFileSync(MEASURED, `${JSON.stringify(measured, null, 2)}\n`)
  const [before, rest] = readFileSync(PAGE, 'utf8').split(MARKS[0])
  const [, after] = rest.split(MARKS[1])
  writeFileSync(PAGE, `${before}${MARKS[0]}\n\n${browserTable(measured)}\n\n${MARKS[1]}${after}`)
}
