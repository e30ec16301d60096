// What must hold before every change: `npm test`. The rest, before a release: `npm run test:heavy`. What follows `--` goes to Vitest, e.g.
// `npm test -- --project unit`.

import { readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser, readAdapters } from './lib/browser.mjs'
import { setUpPython } from './lib/python.mjs'
import { Failure, main, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

/** Vitest's projects in `npm test` and in `npm run test:heavy`. */
const ALWAYS = ['unit', 'packages', 'gpu', 'gpu-rooms', 'pages']
const HEAVY = ['heavy', 'heavy-packages', 'heavy-pages', 'heavy-gpu', 'gpu-oldest']

/** Tests that were left out are named, as far as this many. */
const LISTED = 20

await main(async () => {
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  say(`browser  ${process.env.FURROW_CHROMIUM}`)
  const adapters = await readAdapters()
  for (const [api, adapter] of Object.entries(adapters)) say(`${api.padEnd(8)} ${adapter ?? 'missing'}`)
  const hasAdapters = Object.values(adapters).every(Boolean)
  const results = [{ name: 'adapters', state: hasAdapters ? 'passed' : 'FAILED' }]

  // Each of these keeps one core busy.
  results.push(
    ...(
      await Promise.all([
        timed('type check', ['npx', 'tsc', '--noEmit']),
        inOrder(() => timed('lint', ['npx', 'biome', 'check', '.']), checkPython, checkDownload),
      ])
    ).flat(),
  )
  const report = join(tmpdir(), `furrow-test-${process.pid}.json`)
  const options = ['--reporter=default', '--reporter=./scripts/lib/project-reporter.mjs', '--allowOnly=false']
  const tests = await timed('tests', ['npx', 'vitest', 'run', ...options, ...vitestWords()], {
    env: { ...process.env, FURROW_TEST_REPORT: report },
  })
  results.push(...readReport(report), tests)
  if (process.env.CI) results.push(await checkRatios())
  summarise(results)
})

/** Arguments for Vitest. Those that name no project get ours. */
function vitestWords() {
  const isHeavy = process.argv[2] === '--heavy'
  const words = process.argv.slice(isHeavy ? 3 : 2)
  if (words.some((word) => word.startsWith('--project'))) return words
  return [...(isHeavy ? HEAVY : ALWAYS).map((name) => `--project=${name}`), ...words]
}

/** The Python of faces/, and of blender/ what needs no Blender. Without Python these checks are left out, but never in CI. */
async function checkPython() {
  const python = await setUpPython()
  if (!python) return [{ name: 'Python', state: process.env.CI ? 'FAILED' : 'left out' }]
  const ruff = [python, '-m', 'ruff']
  return inOrder(
    () => timed('faces format', [...ruff, 'format', '--check', 'faces']),
    () => timed('faces lint', [...ruff, 'check', 'faces']),
    () => timed('faces tests', [python, '-m', 'pytest', '--quiet', 'faces']),
    () => timed('blender format', [...ruff, 'format', '--check', 'blender']),
    () => timed('blender lint', [...ruff, 'check', 'blender']),
    () => timed('blender tests', [python, 'blender/tests/plain.py']),
  )
}

/** What pages download may grow, but not unseen. */
async function checkDownload() {
  // It needs what `setUp` installs.
  const { compareDownload, warnings } = await import('./lib/download.mjs')
  const grown = warnings(await compareDownload())
  return { name: 'download', state: grown.length > 0 ? 'warning' : 'passed', detail: grown.join('\n') }
}

/** What a frame costs may grow, but not unseen. Nothing else must run then. */
async function checkRatios() {
  say('frame')
  const start = performance.now()
  // It needs what `setUp` installs.
  const { measureTwice, readFigures, warnings } = await import('../bench/ratios.mjs')
  const figures = readFigures()
  const grown = await measureTwice(figures).then(
    (ratios) => warnings(ratios, figures),
    ({ message }) => [message],
  )
  const seconds = (performance.now() - start) / 1000
  return { name: 'frame', state: grown.length > 0 ? 'warning' : 'passed', seconds, detail: grown.join('\n') }
}

async function inOrder(...steps) {
  const results = []
  for (const step of steps) results.push(await step())
  return results.flat()
}

/** Tests print as they go; of other steps what they print is shown only if they fail. */
async function timed(name, words, options = { quiet: true }) {
  say(name)
  const start = performance.now()
  const code = await run(words, options)
  return { name, state: code === 0 ? 'passed' : 'FAILED', seconds: (performance.now() - start) / 1000 }
}

/** What became of each of Vitest's projects; none where it did not come so far as to say. */
function readReport(file) {
  try {
    return JSON.parse(readFileSync(file, 'utf8')).map((project) => ({
      ...project,
      state: project.failed > 0 ? 'FAILED' : 'passed',
      detail: `${project.passed} passed, ${project.failed} failed, ${project.leftOut.length} left out`,
    }))
  } catch {
    return []
  } finally {
    rmSync(file, { force: true })
  }
}

function summarise(results) {
  console.info('')
  for (const { name, state, seconds = 0, detail = '' } of results) {
    say(`${name.padEnd(12)} ${state.padEnd(8)} ${seconds.toFixed(1).padStart(6)} s  ${detail}`.trimEnd())
  }
  // With a filter on names there may be hundreds.
  const leftOut = results.flatMap((result) => result.leftOut ?? [])
  for (const test of leftOut.slice(0, LISTED)) say(`left out     ${test}`)
  const failed = results.filter(({ state }) => state === 'FAILED').map(({ name }) => name)
  if (failed.length > 0) throw new Failure(`failed: ${failed.join(', ')}`)
  const missing = results.filter(({ state }) => state === 'left out').map(({ name }) => name)
  say(missing.length > 0 ? `passed, but left out: ${missing.join(', ')}` : 'all passed')
}
