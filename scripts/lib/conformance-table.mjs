// The table of docs/conformance.md: what each engine's runner found, rule by rule.

import { writeTable } from './marked-table.mjs'

/** An engine that lacks what a sample needs has no test for it. */
const CELLS = { true: 'yes', false: '**no**', undefined: 'not supported' }

/** Suites of tests whose names say of which engine they are; each has one test for each sample. */
const SUITE = /conformance of (.+)$/

/**
 * @param report JSON of Vitest.
 * @returns of each engine, the samples and whether they passed.
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

/** Writes the table into the page. */
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

/** A heading of the specification, as GitHub links to it. */
function link(section) {
  const anchor = section
    .toLowerCase()
    .replace(/[^\w -]/g, '')
    .replaceAll(' ', '-')
  return `[${section.replaceAll('_', '\\_')}](FURROW_wrinkle_maps.md#${anchor})`
}
