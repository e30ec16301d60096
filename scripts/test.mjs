// `npm test` checks every change. `npm run test:all` runs the rest, which takes hours on two cores; with
// `-- --shard 2/8` the second of eight parts, with `-- --minutes 10` what that time allows, what changed lately first.
// Other words after `--` go to Vitest, e.g. `npm test -- --project unit test/unit/drivers`.

import { spawnSync } from 'node:child_process'
import { readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser, readAdapters } from './lib/browser.mjs'
import { changedFirst } from './lib/changed-tests.mjs'
import { watchCpuTime } from './lib/cpu-time.mjs'
import { missingPackages } from './lib/other-browsers.mjs'
import { setUpPython } from './lib/python.mjs'
import { Failure, main, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'
import { isInAll, isQuick, listTests, VITEST } from './lib/test-files.mjs'

/** Tests that were left out are named, as far as this many. */
const LISTED = 20

/** How many files of tests begin together where time is limited. */
const TOGETHER = 8

/** Time that must be left for more files to begin, in milliseconds. */
const LEAST = 60_000

/** Time that must be left for the site to be built, in milliseconds. */
const SITE = 360_000

/** Steps that some projects need first. */
const PREPARATIONS = {
  site: async () => {
    if (Date.now() > process.env.FURROW_TEST_UNTIL - SITE) return [{ name: 'site', state: 'left out' }]
    return [await timed('build site', [process.execPath, 'site/build.mjs'])]
  },
  batch: async () => {
    if (spawnSync('redis-server', ['--version']).status === 0) return []
    say('redis    missing; install redis-server to test furrow batch with it')
    return [{ name: 'batch', state: 'left out' }]
  },
  firefox: () => checkBrowser('firefox', ['firefox']),
  webkit: () => checkBrowser('webkit', ['webkit']),
  browsers: () => checkBrowser('browsers', ['firefox', 'webkit']),
}

const cpu = watchCpuTime()
let parts = 0

await main(async () => {
  const { isAll, shard, minutes, words } = readArguments(process.argv.slice(2))
  const until = minutes === undefined ? undefined : Date.now() + minutes * 60_000
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  say(`browser  ${process.env.FURROW_CHROMIUM}`)
  if (isAll) process.env.FURROW_TESTS = 'all'
  const results = [await checkAdapters()]
  if (words.length > 0) results.push(...(await testWith(words)))
  else if (isAll) results.push(...(await testAll(shard, until)))
  else results.push(...(await testQuickly()))
  summarise(results)
})

/** Our own options; all else is for Vitest. */
function readArguments(words) {
  const own = { isAll: false, shard: undefined, minutes: undefined, words: [] }
  while (words.length > 0) {
    const word = words.shift()
    if (word === '--all') own.isAll = true
    else if (word === '--shard' && own.isAll) own.shard = readShard(words.shift())
    else if (word === '--minutes' && own.isAll) own.minutes = Number(words.shift())
    else own.words.push(word)
  }
  if (Number.isNaN(own.minutes)) throw new Failure('test: --minutes is not a number; give it one, e.g. 10')
  return own
}

function readShard(text) {
  const [, index, count] = (/^(\d+)\/(\d+)$/.exec(text) ?? []).map(Number)
  if (index >= 1 && index <= count) return { index, count }
  throw new Failure(`test: --shard is "${text}", allowed: I/N with I from 1 to N; e.g. 2/8`)
}

/** Runs `npm test`, two parts at a time, each of which keeps a core busy. */
async function testQuickly() {
  const tests = (await listTests()).filter(isQuick)
  return sideBySide([
    ...partsOf(tests),
    () => timed('type check', node('typescript/bin/tsc', '--noEmit')),
    () => timed('lint', node('@biomejs/biome/bin/biome', 'check', '.')),
    checkPython,
    checkDownload,
  ])
}

/** Runs the tests that `npm test` leaves out: all, one shard, or as many as the time allows. */
async function testAll(shard, until) {
  const tests = (await listTests()).filter(isInAll)
  if (until === undefined) {
    const mine = tests.filter((_, i) => !shard || i % shard.count === shard.index - 1)
    return sideBySide(partsOf(mine))
  }
  const results = []
  process.env.FURROW_TEST_UNTIL = until
  let rest = changedFirst(tests)
  while (rest.length > 0 && Date.now() < until - LEAST) {
    results.push(...(await sideBySide(partsOf(rest.slice(0, TOGETHER)))))
    rest = rest.slice(TOGETHER)
  }
  say(`${tests.length - rest.length} of ${tests.length} files begun in this time`)
  return results
}

/** Runs the tests that the words for Vitest name. */
async function testWith(words) {
  const [, project] = /--project[= ](\S+)/.exec(words.join(' ')) ?? []
  return prepared(project, () => vitest(project ?? 'tests', words))
}

/** One part for each project that runs some of these tests. */
function partsOf(tests) {
  const projects = [...new Set(tests.map(({ project }) => project))]
  return projects.map((project) => async () => {
    const files = tests.filter((test) => test.project === project).map(({ file }) => file)
    return prepared(project, () => vitest(project, [`--project=${project}`, ...files]))
  })
}

/** Results of a project's tests after those of what it needs first, without which there are none. */
async function prepared(project, test) {
  const before = (await PREPARATIONS[project]?.()) ?? []
  return before.every(({ state }) => state === 'passed') ? [...before, await test()] : before
}

/** Leaves a project out where the packages of its browsers are missing. */
async function checkBrowser(name, browsers) {
  const missing = [...new Set(browsers.flatMap(missingPackages))]
  if (missing.length === 0) return []
  say(`${name.padEnd(8)} missing; apt-get install ${missing.join(' ')} to test in it`)
  return [{ name, state: 'left out' }]
}

/** Words that run a script of an installed package. */
function node(script, ...words) {
  return [process.execPath, `node_modules/${script}`, ...words]
}

async function checkAdapters() {
  const adapters = await readAdapters()
  for (const [api, adapter] of Object.entries(adapters)) say(`${api.padEnd(8)} ${adapter ?? 'missing'}`)
  return { name: 'adapters', state: Object.values(adapters).every(Boolean) ? 'passed' : 'FAILED' }
}

/** The Python of faces/, and of blender/ what needs no Blender. Without Python these checks are left out, but never in CI. */
async function checkPython() {
  const python = await setUpPython()
  if (!python) return [{ name: 'Python', state: process.env.CI ? 'FAILED' : 'left out' }]
  const ruff = [python, '-m', 'ruff']
  return inOrder(
    () => timed('ruff format', [...ruff, 'format', '--check', 'faces', 'blender']),
    () => timed('ruff check', [...ruff, 'check', 'faces', 'blender']),
    () => timed('faces', [python, '-m', 'pytest', '--quiet', 'faces']),
    () => timed('blender', [python, 'blender/tests/plain.py']),
  )
}

/** What pages download may grow, but not unseen. */
async function checkDownload() {
  // It needs what `setUp` installs.
  const { compareDownload, warnings } = await import('./lib/download.mjs')
  const grown = warnings(await compareDownload())
  return { name: 'download', state: grown.length > 0 ? 'warning' : 'passed', detail: grown.join('\n') }
}

/** Results in the order of the steps, which two lanes take one after the other. */
async function sideBySide(steps) {
  const results = []
  const rest = [...steps.entries()]
  const lane = async () => {
    for (let next = rest.shift(); next; next = rest.shift()) results[next[0]] = await next[1]()
  }
  await Promise.all([lane(), lane()])
  return results.flat()
}

async function inOrder(...steps) {
  const results = []
  for (const step of steps) results.push(await step())
  return results.flat()
}

/** Runs Vitest, which prints as it goes. */
async function vitest(name, words) {
  const report = join(tmpdir(), `furrow-test-${process.pid}-${parts++}.json`)
  const reporters = ['--reporter=default', '--reporter=./scripts/lib/project-reporter.mjs']
  const env = { ...process.env, FURROW_TEST_REPORT: report }
  const result = await timed(name, [...VITEST, 'run', ...reporters, '--allowOnly=false', ...words], { env })
  const options = words.filter((word) => word.startsWith('--'))
  try {
    const { passed, failed, leftOut, failedFiles, isCutOff } = JSON.parse(readFileSync(report, 'utf8'))
    const detail = `${passed} passed, ${failed} failed, ${leftOut.length} left out${isCutOff ? ', cut off' : ''}`
    // Vitest calls a run that was cut off failed.
    const state = isCutOff ? 'passed' : result.state
    return { ...result, state, detail, leftOut, again: ['npx', 'vitest', 'run', ...options, ...failedFiles] }
  } catch {
    // It did not come so far as to say.
    return result
  } finally {
    rmSync(report, { force: true })
  }
}

/** Runs a step. The output of steps other than tests is shown only if they fail. */
async function timed(name, words, options = { quiet: true }) {
  say(name)
  const start = performance.now()
  let id
  const started = (child) => {
    id = child
  }
  const code = await run(words, { ...options, started })
  const seconds = (performance.now() - start) / 1000
  return { name, state: code === 0 ? 'passed' : 'FAILED', seconds, cpuSeconds: cpu.seconds(id), again: words }
}

function timesOf(seconds, cpuSeconds) {
  const [time, cpuTime] = [seconds, cpuSeconds ?? 0].map((value) => `${value.toFixed(1).padStart(6)} s`)
  return cpuSeconds === undefined ? time : `${time} ${cpuTime} of CPU`
}

function summarise(results) {
  console.info('')
  for (const { name, state, seconds = 0, cpuSeconds, detail = '' } of results) {
    say(`${name.padEnd(12)} ${state.padEnd(8)} ${timesOf(seconds, cpuSeconds)}  ${detail}`.trimEnd())
  }
  cpu.look()
  say(`${'in all'.padEnd(21)} ${timesOf(performance.now() / 1000, cpu.seconds(process.pid))}`)
  // With a filter on names there may be hundreds.
  const leftOut = results.flatMap((result) => result.leftOut ?? [])
  for (const test of leftOut.slice(0, LISTED)) say(`left out     ${test}`)
  const failed = results.filter(({ state }) => state === 'FAILED')
  const variables = process.env.FURROW_TESTS ? `FURROW_TESTS=${process.env.FURROW_TESTS} ` : ''
  for (const { again } of failed) if (again) say(`again: ${variables}${again.join(' ')}`)
  if (failed.length > 0) throw new Failure(`failed: ${failed.map(({ name }) => name).join(', ')}`)
  const missing = results.filter(({ state }) => state === 'left out').map(({ name }) => name)
  say(missing.length > 0 ? `passed, but left out: ${missing.join(', ')}` : 'all passed')
}
