// Runs each mutant against the tests that reach it:
//     node test/mutants/run.mjs [--mutants shaders.json] [--ids 1,2] [--output FILE]
// The first test file that fails kills the mutant. Known killers run first, so a run is short if they still kill their mutants.

import { execFileSync, spawn } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { runnerImport } from 'vite'
import { createVitest } from 'vitest/node'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const CONFIG = join(ROOT, 'test/mutants/vitest.config.ts')
/** The time limit of a run is six times the usual duration plus this number of seconds. A mutant that exceeds the limit counts as killed. */
const PATIENCE = 60

const { values } = parseArgs({
  options: {
    mutants: { type: 'string', default: 'mutants.json' },
    ids: { type: 'string' },
    // Folder of an earlier run that has measured which tests reach which mutants.
    reached: { type: 'string' },
    // Seconds of tests to run per mutant, measured without mutants. If none of these tests fails, the mutant survives.
    budget: { type: 'string', default: 'Infinity' },
    output: { type: 'string' },
  },
})
const list = JSON.parse(readFileSync(join(ROOT, 'test/mutants', values.mutants), 'utf8'))
const ids = values.ids?.split(',').map(Number)
const lost = await findLost()
const chosen = list.mutants.filter(({ id }) => (ids?.includes(id) ?? true) && !lost.includes(id))

let vitest
let reached
const survivors = []
for (const mutant of chosen) {
  const began = performance.now()
  mutant.killers = await (mutant.tests ? killersOfShader(mutant) : killersOf(mutant))
  const seconds = ((performance.now() - began) / 1000).toFixed(0)
  if (mutant.killers.length === 0) survivors.push(mutant.id)
  const result = mutant.killers.length > 0 ? `killed by ${mutant.killers.join(', ')}` : 'survived'
  console.info(`${mutant.id} ${result} (${seconds} s) ${mutant.file}: ${mutant.line}`)
  if (values.output) writeFileSync(values.output, textOf(list))
}
const killed = chosen.length - survivors.length
console.info(`${killed} of ${chosen.length} killed; lost: ${lost.length}; survivors: ${survivors.join(', ')}`)
process.exit()

/** Writes one mutant per line. */
function textOf({ mutants, ...others }) {
  const lines = mutants.map((mutant) => `    ${JSON.stringify(mutant)}`)
  return `${JSON.stringify({ ...others, mutants: [] }, null, 2).replace('[]', () => `[\n${lines.join(',\n')}\n  ]`)}\n`
}

/** Returns the ids of mutants that cannot be located in the sources. */
async function findLost() {
  const { module } = await runnerImport(join(ROOT, 'test/mutants/instrument.ts'))
  const { lost } = module.findMutants(list.mutants, ROOT)
  for (const { id, file, line } of lost) console.info(`${id} is lost: ${file}: ${line}`)
  return lost.map(({ id }) => id)
}

/** Finds tests that fail with a mutant. Order: tests with the mutated file's name, tests in its folder, other tests; fast tests first. */
async function killersOf(mutant) {
  const known = (mutant.killers ?? []).filter((path) => existsSync(join(ROOT, path)))
  for (const file of known) {
    const killers = await failing(mutant, [{ file, seconds: PATIENCE }])
    if (killers.length > 0) return killers
  }
  reached ??= await measureReach()
  const tests = reached
    .filter((each) => each.reached.includes(mutant.id))
    .sort((a, b) => distance(mutant, a) - distance(mutant, b) || a.seconds - b.seconds)
  let left = Number(values.budget)
  while (tests.length > 0 && left > 0) {
    const lot = tests.splice(0, 3)
    const killers = await failing(mutant, lot)
    if (killers.length > 0) return killers
    left -= secondsOf(lot)
  }
  return []
}

function distance({ file, room }, test) {
  const [, folder] = test.file.match(/^test\/unit\/(\w+)\//) ?? []
  if (basename(file, '.ts') === basename(test.file, '.test.ts')) return 0
  return folder === (room === 'files' ? 'cli' : room) ? 1 : 2
}

function secondsOf(tests) {
  return tests.reduce((sum, { seconds }) => sum + seconds, 0)
}

/** Returns the files of `tests` that fail with a mutant, or all files of `tests` if the run crashes or exceeds the time limit. */
async function failing({ id }, tests) {
  process.env.FURROW_MUTANT = String(id)
  vitest ??= await createVitest('test', { config: CONFIG, root: ROOT, watch: false, reporters: [{}] })
  const paths = tests.map(({ file }) => join(ROOT, file))
  const specifications = vitest.projects.flatMap((project) =>
    paths.map((path) => project.createSpecification(path)),
  )
  let timer
  const ended = await Promise.race([
    vitest.runTestSpecifications(specifications).catch((error) => ({ error })),
    new Promise((resolve) => {
      timer = setTimeout(resolve, 1000 * (PATIENCE + 6 * secondsOf(tests)))
    }),
  ])
  clearTimeout(timer)
  if (ended?.testModules) {
    const modules = new Map(ended.testModules.map((module) => [module.moduleId, module]))
    return tests.map(({ file }) => file).filter((file) => !modules.get(join(ROOT, file))?.ok())
  }
  // A worker process hangs or has crashed.
  for (const child of childrenOf(process.pid)) process.kill(child, 'SIGKILL')
  vitest = undefined
  return tests.map(({ file }) => file)
}

function childrenOf(pid) {
  const table = execFileSync('ps', ['-o', 'pid=,ppid=,args=', '-e'], { encoding: 'utf8' })
  const rows = table.split('\n').map((row) => row.trim().split(/\s+/))
  return rows
    .filter(([, parent, ...args]) => Number(parent) === pid && args.join(' ').includes('vitest'))
    .map(([child]) => Number(child))
}

/** Measures which mutants each test file reaches, and how long the file runs. Leaves out files that fail without mutants. */
async function measureReach() {
  const folder = values.reached ?? mkdtempSync(join(tmpdir(), 'furrow-reached-'))
  const report = join(folder, 'report')
  if (!values.reached) await runAlone([], { FURROW_REACHED: folder }, report)
  const failed = failedIn(report)
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'))
  const files = names.map((name) => JSON.parse(readFileSync(join(folder, name), 'utf8')))
  return files.filter(({ file }) => !failed.includes(file))
}

/** Finds the tests that fail with a changed shader. They run one file after the other, because each needs a browser. */
async function killersOfShader({ id, file, tests, killers = [] }) {
  const renderer = file.includes('/webgpu/') ? 'webgpu(?! on)' : 'webgl'
  for (const test of killers.length > 0 ? killers : tests) {
    const env = { FURROW_PROJECT: 'gpu', FURROW_ONLY: String(id), FURROW_MUTANTS: values.mutants }
    const report = join(mkdtempSync(join(tmpdir(), 'furrow-mutant-')), 'report')
    await runAlone([test, '-t', `\\b${renderer}( |$)`, '--bail=1'], env, report)
    const failed = failedIn(report)
    if (failed.length > 0) return failed
  }
  return []
}

/** Runs Vitest in a separate process, and waits for its end. */
function runAlone(words, env, report) {
  const options = ['run', '--config', CONFIG, '--reporter=json', `--outputFile=${report}`, ...words]
  const child = spawn(process.execPath, ['node_modules/vitest/vitest.mjs', ...options], {
    cwd: ROOT,
    env: { ...process.env, ...env },
    stdio: 'ignore',
  })
  return new Promise((resolve) => child.on('exit', resolve))
}

function failedIn(report) {
  const { testResults } = JSON.parse(readFileSync(report, 'utf8'))
  return testResults.filter(({ status }) => status === 'failed').map(({ name }) => name.slice(ROOT.length))
}
