// Makes the sample files of the conformance suite, reads them with all engines, and writes the table of docs/conformance.md:
// `npm run conformance`. `--files` only makes the files.

import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { resultsOf, writeConformance } from './lib/conformance-table.mjs'
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
  // It needs what the set-up installs.
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
  const report = await reported((file) => {
    const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`]
    const env = { ...process.env, FURROW_TESTS: 'all' }
    return run(['npx', 'vitest', 'run', '--project', 'gpu', 'test/gpu/conformance', ...reporters], { env })
  })
  return resultsOf(report)
}

/** Of each sample whether it passed; those that Blender leaves out are missing. */
async function runBlender() {
  const words = ['node', 'scripts/blender.mjs', '--version', '4.5', 'test_conformance.py']
  const report = await reported((file) => {
    return run(words, { env: { ...process.env, FURROW_CONFORMANCE_REPORT: file } })
  })
  return new Map(Object.entries(report))
}

/** The JSON that a program writes into a file. */
async function reported(write) {
  const folder = await mkdtemp(join(tmpdir(), 'furrow-conformance-'))
  const file = join(folder, 'report.json')
  try {
    await write(file)
    return JSON.parse(await readFile(file, 'utf8'))
  } finally {
    await rm(folder, { recursive: true })
  }
}
