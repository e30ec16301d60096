// What a process that is used again saves: `furrow auto` on one face several times in one process, in seconds.
// node bench/batch/warm.mjs FACE [SIZE]; with `node --cpu-prof` it tells where the time goes.

import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { gatherPrinted } from '../../packages/cli/dist/print.js'

const RUNS = 8
const [, , face, size = '1024'] = process.argv

const start = performance.now()
const { autoCommand } = await import('../../packages/cli/dist/commands/auto.js')
console.info(`loading: ${((performance.now() - start) / 1000).toFixed(2)}`)
const folder = mkdtempSync(join(tmpdir(), 'furrow-warm-'))
const words = [face, '-o', join(folder, 'face.glb'), '--size', size, '--replace']
for (let run = 1; run <= RUNS; run++) {
  const [begin, before] = [performance.now(), process.cpuUsage()]
  await gatherPrinted({ lines: [], warnings: [] }, () => autoCommand.parseAsync(words, { from: 'user' }))
  const { user, system } = process.cpuUsage(before)
  const seconds = (performance.now() - begin) / 1000
  console.info(`run ${run}: ${seconds.toFixed(2)}, of the processor ${((user + system) / 1e6).toFixed(2)}`)
}
rmSync(folder, { recursive: true })
