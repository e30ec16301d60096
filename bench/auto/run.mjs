// `node bench/auto/run.mjs [face.glb] [--size 1024] [--json FILE]`: times `furrow auto` by stage. See README.md.

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
const results = cases.map(({ face, size, rounds }) => ({
  face: basename(face),
  size: Number(size),
  milliseconds: Object.fromEntries(
    STAGES.map((stage) => [stage, median(rounds.map(({ stages }) => stages[stage]))]),
  ),
  total: median(rounds.map(({ stages }) => STAGES.reduce((sum, stage) => sum + stages[stage], 0))),
  megabytes: median(rounds.map((round) => round.megabytes)),
}))
process.stdout.write(
  `${processorName()}, ${cpus().length} cores, Node ${process.version}; median of ${ROUNDS} rounds\n\n`,
)
process.stdout.write(table(results))
if (options.json) await writeFile(options.json, `${JSON.stringify(results, null, 2)}\n`)

/** Lists the existing faces, and writes faces with mirrored UVs. */
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

/** Formats results as a Markdown table, in seconds. */
function table(rows) {
  const head = ['face', 'size', ...STAGES, 'all', 'memory']
  const cells = rows.map(({ face, size, milliseconds, total, megabytes }) => [
    face,
    size,
    ...STAGES.map((stage) => seconds(milliseconds[stage])),
    `**${seconds(total)}**`,
    `${Math.round(megabytes)} MB`,
  ])
  return `${[head, head.map(() => '---'), ...cells].map((row) => `| ${row.join(' | ')} |`).join('\n')}\n`
}

function seconds(milliseconds) {
  return (milliseconds / 1000).toFixed(2)
}
