// `npm run conformance`: writes the conformance samples, tests all engines with them, and updates the table of
// docs/conformance.md. `-- --files` only writes the samples.

import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { resultsOf, writeConformance } from './lib/conformance-table.mjs'
import { setUpGodot } from './lib/godot.mjs'
import { Failure, main, ROOT, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  const samples = await makeFiles()
  say(`${samples.length} samples in conformance/files`)
  if (process.argv.includes('--files')) return
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const engines = new Map([...(await runEngines()), ['Blender (activations)', await runBlender()]])
  writeConformance(samples, engines)
  for (const [engine, results] of engines) {
    const passed = [...results.values()].filter(Boolean).length
    say(`${engine}: ${passed} of ${results.size}`)
  }
  if ([...engines.values()].some((results) => [...results.values()].includes(false))) {
    throw new Failure('some samples failed, see docs/conformance.md')
  }
})

async function makeFiles() {
  // Imported late, because the module needs packages that `setUp` installs.
  const { serve } = await import('../bench/serve.mjs')
  const server = await serve()
  try {
    const { SAMPLES } = await server.ssrLoadModule('/conformance/src/samples.ts')
    const { filesOf } = await server.ssrLoadModule('/conformance/src/make.ts')
    const folder = join(ROOT, 'conformance', 'files')
    await rm(folder, { recursive: true, force: true })
    await mkdir(folder)
    for (const sample of SAMPLES) {
      for (const [name, bytes] of await filesOf(sample)) await writeFile(join(folder, name), bytes)
    }
    return SAMPLES
  } finally {
    await server.close()
  }
}

async function runEngines() {
  await setUpGodot()
  const report = await readReport((file) => {
    const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`]
    const env = { ...process.env, FURROW_TESTS: 'all' }
    const projects = ['--project', 'gpu', '--project', 'godot']
    const files = ['test/gpu/conformance', 'test/godot/conformance.test.ts']
    return run(['npx', 'vitest', 'run', ...projects, ...files, ...reporters], { env })
  })
  return resultsOf(report)
}

/** Tests the samples in Blender. Returns per sample whether it passed. Samples that Blender skips are missing. */
async function runBlender() {
  const words = ['node', 'scripts/blender.mjs', '--version', '4.5', 'test_conformance.py']
  const report = await readReport((file) => {
    return run(words, { env: { ...process.env, FURROW_CONFORMANCE_REPORT: file } })
  })
  return new Map(Object.entries(report))
}

/** Calls `write`, which writes a JSON report to the path in its argument. Returns the parsed report. */
async function readReport(write) {
  const folder = await mkdtemp(join(tmpdir(), 'furrow-conformance-'))
  const file = join(folder, 'report.json')
  try {
    await write(file)
    return JSON.parse(await readFile(file, 'utf8'))
  } finally {
    await rm(folder, { recursive: true })
  }
}
