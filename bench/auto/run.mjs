// `node bench/auto/run.mjs [face.glb] [--size 1024] [--json FILE]`: measures CPU time and memory of each stage of `furrow auto`. See README.md.

import { execFile } from 'node:child_process'
import { existsSync, readFileSync, rmSync } from 'node:fs'
import { mkdtemp, writeFile } from 'node:fs/promises'
import { cpus, tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs, promisify } from 'node:util'
import { bundle } from '../../scripts/lib/bundle.mjs'
import { median } from '../median.mjs'

const ROUNDS = 5
const fromHere = (path) => fileURLToPath(new URL(path, import.meta.url))
const FACES = ['../../faces/human.glb', '../../../shared/real-face/ict-face.glb'].map(fromHere)
const STAGES = ['start', 'read', 'face', 'lines', 'drivers', 'layers', 'maps', 'encode', 'write']

const { values: options, positionals } = parseArgs({
  options: { size: { type: 'string' }, json: { type: 'string' } },
  allowPositionals: true,
})
const folder = await mkdtemp(join(tmpdir(), 'furrow-bench-'))
process.on('exit', () => rmSync(folder, { recursive: true }))
const faces = positionals.length > 0 ? positionals : await allFaces()
const sizes = options.size ? [options.size] : ['1024', '2048']
const cases = faces.flatMap((face) => sizes.map((size) => ({ face, size, rounds: [] })))

// Cases take turns, so that a temporary slowdown affects all of them.
for (let round = 0; round < ROUNDS; round++) {
  for (const { face, size, rounds } of cases) rounds.push(await measure(face, size))
}
const results = cases.map(({ face, size, rounds }) => {
  const of = (value) => median(rounds.map(value))
  const stages = STAGES.map((stage) => ({
    stage,
    seconds: of(({ stages }) => stages[stage].seconds),
    megabytes: of(({ stages }) => stages[stage].megabytes),
  }))
  const seconds = of(({ stages }) => STAGES.reduce((sum, stage) => sum + stages[stage].seconds, 0))
  return { face: basename(face), size: Number(size), stages, seconds }
})
process.stdout.write(
  `${processorName()}, ${cpus().length} cores, Node ${process.version}; median of ${ROUNDS} rounds\n\n`,
)
process.stdout.write(timeTable(results))
process.stdout.write(`\n${memoryTable(results)}`)
if (options.json) await writeFile(options.json, `${JSON.stringify(results, null, 2)}\n`)

/** Writes files with mirrored UVs to the temporary folder. Returns their paths, and the paths of the existing files in `FACES`. */
async function allFaces() {
  const { writeMirrored } = await import(await bundle('bench/auto/mirrored.ts'))
  return [...FACES.filter((path) => existsSync(path)), ...(await writeMirrored(FACES[0], folder))]
}

async function measure(face, size) {
  const { stdout } = await promisify(execFile)(process.execPath, [fromHere('measure.mjs'), face, size])
  return JSON.parse(stdout)
}

function processorName() {
  const model =
    existsSync('/proc/cpuinfo') && /^model name\s*: (.*)$/m.exec(readFileSync('/proc/cpuinfo', 'utf8'))
  return model ? model[1] : cpus()[0].model
}

function timeTable(rows) {
  const cells = rows.map(({ face, size, stages, seconds }) => [
    face,
    size,
    ...stages.map((stage) => stage.seconds.toFixed(2)),
    `**${seconds.toFixed(2)}**`,
  ])
  return table([['face', 'size', ...STAGES, 'all'], ...cells])
}

function memoryTable(rows) {
  const cells = rows.map(({ face, size, stages }) => [
    face,
    size,
    ...stages.map(({ megabytes }) => Math.round(megabytes)),
  ])
  return table([['face', 'size', ...STAGES], ...cells])
}

function table([head, ...cells]) {
  return `${[head, head.map(() => '---'), ...cells].map((row) => `| ${row.join(' | ')} |`).join('\n')}\n`
}
