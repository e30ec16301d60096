// `npm run auto-tables`: measures the wrinkles of random people, see docs/auto-people.md. Options:
// --identities 100: number of people. The first 30 are for calibration, the tables describe the others.
// --calibrate: describe the first 30 instead.
// --write: write the tables into docs/auto-people.md.

import { execFile } from 'node:child_process'
import { mkdtemp, rm } from 'node:fs/promises'
import { availableParallelism, cpus, tmpdir } from 'node:os'
import { join } from 'node:path'
import { parseArgs, promisify } from 'node:util'
import { bundle } from '../../../scripts/lib/bundle.mjs'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { writeTable } from '../../../scripts/lib/marked-table.mjs'
import { Failure, main, ROOT, say } from '../../../scripts/lib/run.mjs'
import { wholeNumber } from '../../../scripts/lib/whole-number.mjs'
import { setUpSampleHeads } from '../sample-heads.mjs'

/** Number of people on whom constants of the algorithm may be tuned. */
const CALIBRATION = 30

await main(async () => {
  const { values } = parseArgs({
    options: {
      identities: { type: 'string', default: '100' },
      calibrate: { type: 'boolean', default: false },
      write: { type: 'boolean', default: false },
    },
  })
  if (values.calibrate && values.write)
    throw new Failure(
      'the tables of docs/auto-people.md describe the people after the first 30; omit --calibrate',
    )
  const count = wholeNumber('identities', values.identities, values.calibrate ? 1 : CALIBRATION + 1)
  const seeds = Array.from({ length: count }, (_, i) => i + 1)
  const chosen = values.calibrate ? seeds.slice(0, CALIBRATION) : seeds.slice(CALIBRATION)
  const people = await measure(chosen)
  const { skinAt } = await importSource('test/skin-at.ts')
  const { identityTables } = await importSource('bench/auto/identities/tables.ts')
  const machine = `${cpus()[0].model}, ${cpus().length} cores, Node ${process.version}`
  const tables = [
    `Heads ${chosen[0]} to ${chosen.at(-1)}, on ${machine}:`,
    '',
    ...identityTables(people, await skinAt(join(ROOT, 'faces/human.glb'))),
  ]
  console.info(tables.join('\n'))
  if (values.write) writeTable('docs/auto-people.md', 'identities', tables)
})

/** Builds and measures the heads with the given seeds, one process per core. */
async function measure(seeds) {
  const stop = new AbortController()
  // npm repeats a signal that the terminal also sends, so the handlers stay.
  for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => stop.abort())
  const commandFor = await setUpSampleHeads()
  const script = await bundle('bench/auto/identities/measure-identity.ts')
  const { runConcurrently } = await importSource('packages/cli/src/batch/run-concurrently.ts')
  const folder = await mkdtemp(join(tmpdir(), 'furrow-identities-'))
  const run = (...words) =>
    promisify(execFile)(words[0], words.slice(1), { cwd: ROOT, signal: stop.signal, maxBuffer: 2 ** 26 })
  const people = []
  try {
    await runConcurrently(seeds, availableParallelism(), async (seed, i) => {
      const head = join(folder, `realistic-${seed}.glb`)
      await run(...commandFor('realistic', seed, folder))
      const { stdout } = await run(process.execPath, script, head)
      await rm(head)
      people[i] = JSON.parse(stdout)
      say(`head ${seed} of ${seeds.at(-1)}: ${people[i].seconds.toFixed(1)} s for a face`)
    })
  } catch (error) {
    throw stop.signal.aborted ? new Failure('stopped early') : error
  } finally {
    await rm(folder, { recursive: true })
  }
  return people
}
