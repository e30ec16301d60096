// The table of docs/conformance.md: results by rule and engine.

import { writeTable } from './marked-table.mjs'

/** A missing result means that the engine does not support a feature the sample needs. */
const CELLS = { true: 'yes', false: '**no**', undefined: 'not supported' }

/** Test suites named after their engine, with one test per sample. */
const SUITE = /conformance of (.+)$/

/**
 * Reads whether each engine passed each sample.
 *
 * @param report Vitest's JSON report.
 * @returns {Map<string, Map<string, boolean>>} results by engine and sample.
 */
export function resultsOf(report) {
  const engines = new Map()
  for (const { ancestorTitles, title, status } of report.testResults.flatMap(
    (file) => file.assertionResults,
  )) {
    const [, engine] = ancestorTitles.join(' ').match(SUITE) ?? []
    if (!engine) continue
    if (!engines.has(engine)) engines.set(engine, new Map())
    engines.get(engine).set(title, status === 'passed')
  }
  return engines
}

/** Updates the table in the page. */
export function writeConformance(samples, engines) {
  const names = [...engines.keys()]
  const rows = samples.map(({ name, rule, section }) => {
    const cells = names.map((engine) => CELLS[String(engines.get(engine).get(name))])
    return `| [\`${name}\`](../conformance/files/${name}.json) | ${rule} | ${link(section)} | ${cells.join(' | ')} |`
  })
  const table = [
    `| sample | rule | specification | ${names.join(' | ')} |`,
    `| --- | --- | --- |${' --- |'.repeat(names.length)}`,
    ...rows,
  ]
  writeTable('docs/conformance.md', 'table', table)
}

/** Links to a heading of the specification with GitHub's anchor. */
function link(section) {
  const anchor = section
    .toLowerCase()
    .replace(/[^\w -]/g, '')
    .replaceAll(' ', '-')
  return `[${section.replaceAll('_', '\\_')}](FURROW_wrinkle_maps.md#${anchor})`
}
