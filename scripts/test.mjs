// `npm test` checks every change. `npm run test:all` runs the remaining tests, and some tests again with more renderers
// or random cases, which takes hours on two cores. Its options: `-- --shard 2/8` runs the second of eight parts.
// `-- --minutes 10` starts with tests of recent changes, and stops after 10 minutes. Other arguments go to Vitest, e.g.
// `npm test -- --project unit test/unit/drivers`.

import { spawnSync } from 'node:child_process'
import { readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser, readAdapters } from './lib/browser.mjs'
import { changedFirst } from './lib/changed-tests.mjs'
import { watchCpuTime } from './lib/cpu-time.mjs'
import { setUpGodot } from './lib/godot.mjs'
import { missingPackages } from './lib/other-browsers.mjs'
import { setUpPython } from './lib/python.mjs'
import { Failure, main, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'
import { isInAll, isQuick, listTests, VITEST } from './lib/test-files.mjs'

const MAX_LISTED = 20

/** With a time limit, this number of test files is started together. */
const BATCH_SIZE = 8

/** With a time limit, tests are started only if this many milliseconds remain. */
const BATCH_TIME = 60_000

/** With a time limit, the site is built only if this many milliseconds remain. */
const SITE_TIME = 360_000

/** Steps that run before the tests of a project. */
const PREPARATIONS = {
  site: async () => {
    if (Date.now() > process.env.FURROW_TEST_UNTIL - SITE_TIME) return [{ name: 'site', state: 'skipped' }]
    return [await timed('build site', [process.execPath, 'site/build.mjs'])]
  },
  godot: async () => {
    try {
      await setUpGodot()
      return []
    } catch (error) {
      say(`godot    missing: ${error.message}`)
      return [{ name: 'godot', state: 'skipped' }]
    }
  },
  batch: async () => {
    if (spawnSync('redis-server', ['--version']).status === 0) return []
    say('redis    missing; install redis-server to test furrow batch with it')
    return [{ name: 'batch', state: 'skipped' }]
  },
  firefox: () => checkBrowser('firefox', ['firefox']),
  webkit: () => checkBrowser('webkit', ['webkit']),
  browsers: () => checkBrowser('browsers', ['firefox', 'webkit']),
}

const cpu = watchCpuTime()
let parts = 0

await main(async () => {
  const { isAll, shard, minutes, args } = readArguments(process.argv.slice(2))
  const until = minutes === undefined ? undefined : Date.now() + minutes * 60_000
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  say(`browser  ${process.env.FURROW_CHROMIUM}`)
  if (isAll) process.env.FURROW_TESTS = 'all'
  const results = [await checkAdapters()]
  if (args.length > 0) results.push(...(await testWith(args)))
  else if (isAll) results.push(...(await testAll(shard, until)))
  else results.push(...(await testQuickly()))
  summarise(results)
})

/** Reads the options of this script. `args` has the other arguments, which go to Vitest. */
function readArguments(words) {
  const options = { isAll: false, shard: undefined, minutes: undefined, args: [] }
  while (words.length > 0) {
    const word = words.shift()
    if (word === '--all') options.isAll = true
    else if (word === '--shard' && options.isAll) options.shard = readShard(words.shift())
    else if (word === '--minutes' && options.isAll) options.minutes = Number(words.shift())
    else options.args.push(word)
  }
  if (Number.isNaN(options.minutes))
    throw new Failure('test: --minutes is not a number; write e.g. --minutes 10')
  return options
}

function readShard(text) {
  const [, index, count] = (/^(\d+)\/(\d+)$/.exec(text) ?? []).map(Number)
  if (index >= 1 && index <= count) return { index, count }
  throw new Failure(
    `test: --shard is invalid, got "${text}", allowed: I/N with I from 1 to N; write e.g. 2/8`,
  )
}

/** Runs the tests and checks of `npm test`. */
async function testQuickly() {
  const tests = (await listTests()).filter(isQuick)
  return inParallel([
    ...partsOf(tests),
    () => timed('type check', node('typescript/bin/tsc', '--noEmit')),
    () => timed('lint', node('@biomejs/biome/bin/biome', 'check', '.')),
    () => timed('prose', [process.execPath, 'scripts/prose.mjs']),
    checkPython,
    checkDownload,
  ])
}

/** Runs the tests of `npm run test:all`: all of them, one shard, or as many as the time limit allows. */
async function testAll(shard, until) {
  const tests = (await listTests()).filter(isInAll)
  if (until === undefined) {
    const mine = tests.filter((_, i) => !shard || i % shard.count === shard.index - 1)
    return inParallel(partsOf(mine))
  }
  const results = []
  process.env.FURROW_TEST_UNTIL = until
  let rest = changedFirst(tests)
  while (rest.length > 0 && Date.now() < until - BATCH_TIME) {
    results.push(...(await inParallel(partsOf(rest.slice(0, BATCH_SIZE)))))
    rest = rest.slice(BATCH_SIZE)
  }
  say(`started ${tests.length - rest.length} of ${tests.length} files within the time limit`)
  return results
}

async function testWith(args) {
  const [, project] = /--project[= ](\S+)/.exec(args.join(' ')) ?? []
  return prepareAndTest(project, () => vitest(project ?? 'tests', args))
}

/** Groups tests by project. Returns one function per project that runs its tests. */
function partsOf(tests) {
  const projects = [...new Set(tests.map(({ project }) => project))]
  return projects.map((project) => async () => {
    const files = tests.filter((test) => test.project === project).map(({ file }) => file)
    return prepareAndTest(project, () => vitest(project, [`--project=${project}`, ...files]))
  })
}

/** Runs the preparations of a project. Then runs its tests, unless a preparation failed. */
async function prepareAndTest(project, test) {
  const before = (await PREPARATIONS[project]?.()) ?? []
  return before.every(({ state }) => state === 'passed') ? [...before, await test()] : before
}

/** Returns a skipped step if packages of the given browsers are missing. */
async function checkBrowser(name, browsers) {
  const missing = [...new Set(browsers.flatMap(missingPackages))]
  if (missing.length === 0) return []
  say(`${name.padEnd(8)} missing; apt-get install ${missing.join(' ')} to test in it`)
  return [{ name, state: 'skipped' }]
}

/** Returns the command that runs the script of an installed package. */
function node(script, ...words) {
  return [process.execPath, `node_modules/${script}`, ...words]
}

async function checkAdapters() {
  const adapters = await readAdapters()
  for (const [api, adapter] of Object.entries(adapters)) say(`${api.padEnd(8)} ${adapter ?? 'missing'}`)
  return { name: 'adapters', state: Object.values(adapters).every(Boolean) ? 'passed' : 'FAILED' }
}

/**
 * Checks faces/, and the parts of blender/ that run without Blender. Without Python the check is skipped, except in CI,
 * where it fails.
 */
async function checkPython() {
  const python = await setUpPython()
  if (!python) return [{ name: 'Python', state: process.env.CI ? 'FAILED' : 'skipped' }]
  const ruff = [python, '-m', 'ruff']
  return inOrder(
    () => timed('ruff format', [...ruff, 'format', '--check', 'faces', 'blender']),
    () => timed('ruff check', [...ruff, 'check', 'faces', 'blender']),
    () => timed('faces', [python, '-m', 'pytest', '--quiet', 'faces']),
    () => timed('blender', [python, 'blender/tests/plain.py']),
  )
}

async function checkDownload() {
  // Imported late, because the module needs packages that `setUp` installs.
  const { compareDownload, warnings } = await import('./lib/download.mjs')
  const grown = warnings(await compareDownload())
  return { name: 'download', state: grown.length > 0 ? 'warning' : 'passed', detail: grown.join('\n') }
}

/** Runs two steps at a time. Each step keeps about one core busy. Returns the results in order. */
async function inParallel(steps) {
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

async function vitest(name, args) {
  const report = join(tmpdir(), `furrow-test-${process.pid}-${parts++}.json`)
  const reporters = ['--reporter=default', '--reporter=./scripts/lib/project-reporter.mjs']
  const env = { ...process.env, FURROW_TEST_REPORT: report }
  const result = await timed(name, [...VITEST, 'run', ...reporters, '--allowOnly=false', ...args], { env })
  const options = args.filter((arg) => arg.startsWith('--'))
  try {
    const { passed, failed, skipped, failedFiles, isCutOff } = JSON.parse(readFileSync(report, 'utf8'))
    const detail = `${passed} passed, ${failed} failed, ${skipped.length} skipped${isCutOff ? ', cut off' : ''}`
    // Vitest reports failure if the time limit cancelled the run.
    const state = isCutOff ? 'passed' : result.state
    return { ...result, state, detail, skipped, rerun: ['npx', 'vitest', 'run', ...options, ...failedFiles] }
  } catch {
    // Vitest failed before it wrote the report.
    return result
  } finally {
    rmSync(report, { force: true })
  }
}

/** Runs a step and measures its time. By default, shows the output of the step only if it fails. */
async function timed(name, words, options = { quiet: true }) {
  say(name)
  const start = performance.now()
  let id
  const started = (child) => {
    id = child
  }
  const code = await run(words, { ...options, started })
  const seconds = (performance.now() - start) / 1000
  return { name, state: code === 0 ? 'passed' : 'FAILED', seconds, cpuSeconds: cpu.seconds(id), rerun: words }
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
  cpu.sample()
  say(`${'total'.padEnd(21)} ${timesOf(performance.now() / 1000, cpu.seconds(process.pid))}`)
  // The list is limited, because a filter on test names can skip hundreds of tests.
  const skipped = results.flatMap((result) => result.skipped ?? [])
  for (const test of skipped.slice(0, MAX_LISTED)) say(`skipped      ${test}`)
  const failed = results.filter(({ state }) => state === 'FAILED')
  const variables = process.env.FURROW_TESTS ? `FURROW_TESTS=${process.env.FURROW_TESTS} ` : ''
  for (const { rerun } of failed) if (rerun) say(`rerun: ${variables}${rerun.join(' ')}`)
  if (failed.length > 0) throw new Failure(`failed: ${failed.map(({ name }) => name).join(', ')}`)
  const missing = results.filter(({ state }) => state === 'skipped').map(({ name }) => name)
  say(missing.length > 0 ? `passed, but skipped: ${missing.join(', ')}` : 'all passed')
}
