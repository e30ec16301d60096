// `node bench/batch/warm.mjs FACE [SIZE] [RUNS]`: runs `furrow auto` several times in one process. Prints the seconds, CPU time and memory of each
// run. Start it with `node --cpu-prof` to record a CPU profile.

import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { capturePrinted } from '../../packages/cli/dist/print.js'

const [, , face, size = '1024', runs = '8'] = process.argv

const start = performance.now()
const { autoCommand } = await import('../../packages/cli/dist/commands/auto.js')
console.info(`loading: ${((performance.now() - start) / 1000).toFixed(2)}`)
const folder = mkdtempSync(join(tmpdir(), 'furrow-warm-'))
const words = [face, '-o', join(folder, 'face.glb'), '--size', size, '--replace']
for (let run = 1; run <= Number(runs); run++) {
  const [begin, before] = [performance.now(), process.cpuUsage()]
  await capturePrinted({ lines: [], warnings: [] }, () => autoCommand.parseAsync(words, { from: 'user' }))
  const { user, system } = process.cpuUsage(before)
  const seconds = (performance.now() - begin) / 1000
  const memory = `${Math.round(process.memoryUsage.rss() / 2 ** 20)} MB`
  console.info(`run ${run}: ${seconds.toFixed(2)}, CPU time ${((user + system) / 1e6).toFixed(2)}, ${memory}`)
}
rmSync(folder, { recursive: true })
