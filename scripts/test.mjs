// Everything that must hold: `npm test`. What follows `--` goes to Vitest, e.g. `npm test -- --project unit`.

import { readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, relative } from 'node:path'
import { ensureBrowser, readAdapters } from './lib/browser.mjs'
import { Failure, main, ROOT, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

/** Tests that were left out are named, as far as this many. */
const LISTED = 20

await main(async () => {
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  say(`browser  ${process.env.FURROW_CHROMIUM}`)
  const adapters = await readAdapters()
  for (const [api, adapter] of Object.entries(adapters)) say(`${api.padEnd(8)} ${adapter ?? 'missing'}`)

  const report = join(tmpdir(), `furrow-test-${process.pid}.json`)
  const steps = [
    ['adapters', async () => (Object.values(adapters).every(Boolean) ? 0 : 1)],
    ['type check', () => run(['npx', 'tsc', '--noEmit'])],
    ['lint', () => run(['npx', 'biome', 'check', '.'])],
    ['tests', () => run(['npx', 'vitest', 'run', ...vitestOptions(report), ...process.argv.slice(2)])],
  ]
  const results = []
  for (const [name, step] of steps) {
    if (name !== 'adapters') say(name)
    const start = performance.now()
    const code = await step()
    results.push({ name, failed: code !== 0, seconds: (performance.now() - start) / 1000 })
  }
  summarise(results, readReport(report))
})

function vitestOptions(report) {
  return ['--reporter=default', '--reporter=json', `--outputFile.json=${report}`, '--allowOnly=false']
}

/** What became of the tests; undefined where Vitest did not come so far as to say. */
function readReport(file) {
  try {
    const { testResults, ...totals } = JSON.parse(readFileSync(file, 'utf8'))
    const leftOut = testResults.flatMap(({ name, assertionResults }) =>
      assertionResults
        .filter(({ status }) => !['passed', 'failed'].includes(status))
        .map(({ fullName }) => `${relative(ROOT, name)}: ${fullName}`),
    )
    return { passed: totals.numPassedTests, failed: totals.numFailedTests, leftOut }
  } catch {
    return undefined
  } finally {
    rmSync(file, { force: true })
  }
}

function summarise(results, report) {
  console.info('')
  const tests = report
    ? `${report.passed} passed, ${report.failed} failed, ${report.leftOut.length} left out`
    : 'no report'
  for (const { name, failed, seconds } of results) {
    const detail = name === 'tests' ? `  ${tests}` : ''
    say(`${name.padEnd(11)} ${failed ? 'FAILED' : 'passed'} ${seconds.toFixed(1).padStart(6)} s${detail}`)
  }
  // With a filter on names there may be hundreds.
  for (const test of report?.leftOut.slice(0, LISTED) ?? []) say(`left out    ${test}`)
  const failed = results.filter((result) => result.failed).map(({ name }) => name)
  if (failed.length > 0) throw new Failure(`failed: ${failed.join(', ')}`)
  say('all passed')
}
