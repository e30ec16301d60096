// Runs each mutant against the unit tests that reach it: node test/mutants/run.mjs [--mutants shaders.json] [--ids 1,2]
//
// A mutant is killed by the first test file that fails. Its known killers run first, so that a run that finds no loss is short.

import { spawn } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const CONFIG = 'test/mutants/vitest.config.ts'
/** Seconds until a mutant counts as killed by an endless loop, beyond those that its tests took before. */
const PATIENCE = 60

const { values } = parseArgs({
  options: {
    mutants: { type: 'string', default: 'mutants.json' },
    ids: { type: 'string' },
    reached: { type: 'string' },
    output: { type: 'string' },
  },
})
const path = join(ROOT, 'test/mutants', values.mutants)
const list = JSON.parse(readFileSync(path, 'utf8'))
const ids = values.ids?.split(',').map(Number)
const lost = await findLost()
const chosen = list.mutants.filter(
  (mutant) => (ids?.includes(mutant.id) ?? true) && !lost.includes(mutant.id),
)

let reached
const survivors = []
for (const mutant of chosen) {
  const began = performance.now()
  mutant.killers = await (mutant.tests ? killersOfShader(mutant) : killersOf(mutant))
  const seconds = (performance.now() - began) / 1000
  if (mutant.killers.length === 0) survivors.push(mutant.id)
  const result = mutant.killers.length > 0 ? `killed by ${mutant.killers.join(', ')}` : 'survived'
  console.info(`${mutant.id} ${result} (${seconds.toFixed(0)} s) ${mutant.file}: ${mutant.line}`)
  if (values.output) writeFileSync(values.output, textOf(list))
}
console.info(
  `${chosen.length - survivors.length} of ${chosen.length} killed; survivors: ${survivors.join(', ')}`,
)

/** A mutant on each line. */
function textOf({ mutants, ...others }) {
  const lines = mutants.map((mutant) => `    ${JSON.stringify(mutant)}`)
  return `${JSON.stringify({ ...others, mutants: [] }, null, 2).replace('[]', () => `[\n${lines.join(',\n')}\n  ]`)}\n`
}

/** Mutants whose line was rewritten. */
async function findLost() {
  const { runnerImport } = await import('vite')
  const { module } = await runnerImport(join(ROOT, 'test/mutants/instrument.ts'))
  const { lost } = module.findMutants(list.mutants, ROOT)
  for (const { id, file, line } of lost) console.info(`${id} is lost: ${file}: ${line}`)
  return lost.map(({ id }) => id)
}

/**
 * What each test file reaches, and how long it takes: from the folder of an earlier run, or from a run without a mutant. Files that fail
 * by themselves tell nothing.
 */
async function whatIsReached() {
  const folder = values.reached ?? mkdtempSync(join(tmpdir(), 'furrow-reached-'))
  const report = join(folder, 'report')
  if (!values.reached) {
    await vitest(['--reporter=json', `--outputFile=${report}`], { FURROW_REACHED: folder })
  }
  const failed = failedIn(report)
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'))
  const files = names.map((name) => JSON.parse(readFileSync(join(folder, name), 'utf8')))
  return files.filter(({ file }) => !failed.includes(file))
}

/** Test files that reach a mutant, the quickest first. */
async function testsOf({ id }) {
  reached ??= await whatIsReached()
  return reached.filter((each) => each.reached.includes(id)).sort((a, b) => a.seconds - b.seconds)
}

/** In three lots, the quickest tests first: most mutants are killed by these. */
async function killersOf(mutant) {
  const env = { FURROW_MUTANT: String(mutant.id) }
  const known = (mutant.killers ?? []).filter((file) => existsSync(join(ROOT, file)))
  if (known.length > 0) {
    const killers = await failing(known, env, 10 * PATIENCE)
    if (killers.length > 0) return killers
  }
  const tests = await testsOf(mutant)
  const lots = [tests.slice(0, 4), tests.slice(4, 16), tests.slice(16)].filter((lot) => lot.length > 0)
  for (const lot of lots) {
    const files = lot.map(({ file }) => file)
    const limit = PATIENCE + 6 * lot.reduce((sum, { seconds }) => sum + seconds, 0)
    const killers = await failing(files, env, limit)
    if (killers.length > 0) return killers
  }
  return []
}

/** On the renderer of the shader, one file after the other: each takes a browser. */
async function killersOfShader({ id, file, tests, killers = [] }) {
  const renderer = file.includes('/webgpu/') ? 'webgpu' : 'webgl'
  for (const test of killers.length > 0 ? killers : tests) {
    const project = test.split('/').length > 3 ? 'gpu-rooms' : 'gpu'
    const env = { FURROW_PROJECT: project, FURROW_ONLY: String(id) }
    const found = await failing([test, '-t', `\\b${renderer} `], env, 10 * PATIENCE)
    if (found.length > 0) return found
  }
  return []
}

/** The test files that fail first. */
async function failing(words, env, limit) {
  const report = join(mkdtempSync(join(tmpdir(), 'furrow-mutant-')), 'report.json')
  const hasEnded = await vitest(
    [...words, '--bail=1', '--reporter=json', `--outputFile=${report}`],
    env,
    limit,
  )
  return hasEnded ? failedIn(report) : ['time']
}

function failedIn(report) {
  const { testResults } = JSON.parse(readFileSync(report, 'utf8'))
  const failed = testResults.filter(({ status }) => status === 'failed')
  return failed.map(({ name }) => name.slice(ROOT.length))
}

/** Whether it ended within the limit. */
function vitest(words, env, limit = 3600) {
  const child = spawn(
    process.execPath,
    ['node_modules/vitest/vitest.mjs', 'run', '--config', CONFIG, ...words],
    { cwd: ROOT, env: { ...process.env, ...env }, stdio: 'ignore', detached: true },
  )
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      process.kill(-child.pid, 'SIGKILL')
      resolve(false)
    }, 1000 * limit)
    child.on('exit', () => {
      clearTimeout(timer)
      resolve(true)
    })
  })
}
