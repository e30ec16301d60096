// Reads and writes the results per engine in the table of docs/conformance.md.

import { writeTable } from './marked-table.mjs'

/** Title of a test suite. The suite is named after an engine and has one test per sample. */
const SUITE = /conformance of (.+)$/

/**
 * Returns per engine and sample whether the engine passed.
 *
 * @param report JSON report of Vitest.
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

/**
 * Updates the table in docs/conformance.md. If a sample has no result for an engine, the engine lacks a feature that
 * the sample needs.
 */
export function writeConformance(samples, engines) {
  const rows = [...engines].map(([engine, results]) => {
    const withResult = (value) =>
      samples.flatMap(({ name }) => (results.get(name) === value ? [`\`${name}\``] : []))
    const passed = `${withResult(true).length} of ${samples.length}`
    const cells = [engine, passed, withResult(false).join(', '), withResult(undefined).join(', ')]
    return `|${cells.map((cell) => (cell ? ` ${cell} |` : ' |')).join('')}`
  })
  const head = ['| engine | passed | failed | not supported |', '| --- | --- | --- | --- |']
  writeTable('docs/conformance.md', 'table', [...head, ...rows])
}
