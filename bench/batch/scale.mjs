// `node bench/batch/scale.mjs FOLDER [SIZE] [MAX_JOBS]`: measures how many faces per second `furrow batch` processes with 1 to `MAX_JOBS` jobs at a
// time.

import { spawnSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { median } from '../median.mjs'

const FURROW = fileURLToPath(new URL('../../packages/cli/bin/furrow.js', import.meta.url))
const ROUNDS = 3
const [, , folder, size = '512', maxJobs = '2'] = process.argv

/** Runs `furrow batch` for all faces of the folder. Returns the seconds, including the start of the command, and the number of faces. */
function measure(jobs) {
  const out = mkdtempSync(join(tmpdir(), 'furrow-scale-'))
  const start = performance.now()
  const words = [
    'batch',
    `${folder}/*.glb`,
    '-o',
    out,
    '--size',
    size,
    '--jobs',
    String(jobs),
    '--thumbnails',
    '0',
    '--json',
  ]
  const { status, stdout, stderr } = spawnSync(process.execPath, [FURROW, ...words], { encoding: 'utf8' })
  const seconds = (performance.now() - start) / 1000
  rmSync(out, { recursive: true })
  if (status !== 0) throw new Error(stderr)
  return { seconds, faces: JSON.parse(stdout).done }
}

const counts = Array.from({ length: Number(maxJobs) }, (_, i) => i + 1)
const rates = counts.map(() => [])
for (let round = 0; round < ROUNDS; round++) {
  for (const [i, jobs] of counts.entries()) {
    const { seconds, faces } = measure(jobs)
    rates[i].push(faces / seconds)
    console.info(
      `${jobs} at a time: ${faces} faces in ${seconds.toFixed(1)} s, ${(faces / seconds).toFixed(2)}/s`,
    )
  }
}
for (const [i, jobs] of counts.entries()) {
  const factor = median(rates[i].map((rate, round) => rate / rates[0][round]))
  console.info(`${jobs}: ${median(rates[i]).toFixed(2)} faces/s, factor ${factor.toFixed(2)}`)
}
