// `npm run bench:studio`: measures response times, memory and download size of the studio. See README.md.

import { mkdtempSync, rmSync } from 'node:fs'
import { writeFile } from 'node:fs/promises'
import { cpus, tmpdir } from 'node:os'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { ROOT, runServed, serve } from '../serve.mjs'
import { buildStudio } from './build.mjs'
import { measureAuto } from './cases/auto.mjs'
import { measureLines } from './cases/lines.mjs'
import { measureMemory } from './cases/memory.mjs'
import { measureOpening } from './cases/opening.mjs'
import { measurePainting } from './cases/painting.mjs'
import { measureSizes } from './cases/sizes.mjs'
import { measureTasks } from './cases/tasks.mjs'
import { writeFiles } from './files.mjs'
import { StudioPage } from './studio-page.mjs'

const CASES = {
  opening: measureOpening,
  painting: measurePainting,
  lines: measureLines,
  memory: measureMemory,
  tasks: measureTasks,
  auto: measureAuto,
  sizes: measureSizes,
}

/** `counts`: numbers of wrinkle lines. `strokes`: number of brush strokes. `autoFaces`: faces and map sizes in texels for automatic wrinkles. */
const FULL = {
  rounds: 5,
  counts: [10, 100, 500],
  strokes: 500,
  autoFaces: [
    ['low', 512],
    ['human', 512],
    ['scan', 1024],
  ],
}
const QUICK = { rounds: 1, counts: [10], strokes: 3, autoFaces: [['low', 256]] }

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    rounds: { type: 'string' },
    only: { type: 'string', multiple: true },
    beside: { type: 'string' },
    json: { type: 'string' },
  },
})

const folder = mkdtempSync(join(tmpdir(), 'furrow-bench-studio-'))
const server = await serve()
await runServed(server, run)
rmSync(folder, { recursive: true, force: true })

async function run() {
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const { toTable } = await server.ssrLoadModule('/bench/studio/table.ts')
  const { withBar } = await server.ssrLoadModule('/packages/cli/src/progress.ts')
  const names = checkNames(options.only ?? Object.keys(CASES))
  const plan = {
    ...(options.quick ? QUICK : FULL),
    ...(options.rounds && { rounds: Number(options.rounds) }),
  }
  const hasSheet = names.includes('tasks') && !options.quick
  const files = await writeFiles(server, folder, { hasSheet })
  const builds = await serveBuilds(files)
  const browser = await launchBrowser()
  const times = new Map()
  let adapter
  try {
    const context = { ...plan, browser, files }
    adapter = await adapterOf({ ...context, ...builds[0] })
    await withBar('bench:studio', async (progress) => {
      let done = 0
      for (let round = 0; round < plan.rounds; round++) {
        for (const name of names) {
          // Both builds are measured in turns, so that a temporary slowdown affects both.
          for (const build of round % 2 ? builds.toReversed() : builds) {
            await CASES[name]({ ...context, ...build }, (figure, time) =>
              record(times, figure, build.name, time),
            )
            progress(++done, plan.rounds * names.length * builds.length)
          }
        }
      }
    })
  } finally {
    await browser.close()
    for (const { close } of builds) close()
  }
  const results = await mediansOf(times)
  const about = { date: new Date().toISOString().slice(0, 10), browser: browser.version(), adapter, ...plan }
  if (options.json) await writeFile(options.json, `${JSON.stringify({ about, results }, null, 2)}\n`)
  const rounds = `median of ${plan.rounds} rounds`
  process.stdout.write(
    `${about.date}, Chromium ${about.browser}, ${adapter}, ${cpus()[0].model}, ${cpus().length} cores, ${rounds}\n\n`,
  )
  const order = builds.map(({ name }) => name)
  process.stdout.write(toTable(results, order))
}

async function serveBuilds(files) {
  const { startStaticServer } = await server.ssrLoadModule('/test/pages/static-server.ts')
  const checkouts = { ...(options.beside && { before: options.beside }), now: ROOT }
  const builds = []
  for (const [name, checkout] of Object.entries(checkouts)) {
    const dist = join(folder, name)
    await buildStudio(checkout, dist, files)
    builds.push({ name, dist, ...(await startStaticServer(dist)) })
  }
  return builds
}

async function adapterOf(context) {
  const studio = await StudioPage.open(context)
  const adapter = await studio.page.evaluate(() => window.probe.adapter())
  await studio.close()
  return adapter
}

/** @param time a number in the unit of the figure, or the milliseconds until a frame was `submitted` and `seen`. */
function record(times, figure, build, time) {
  const { submitted, seen } = typeof time === 'number' ? { submitted: time } : time
  const builds = times.get(figure) ?? {}
  times.set(figure, builds)
  builds[build] ??= { submitted: [], seen: [] }
  builds[build].submitted.push(submitted)
  if (seen !== undefined) builds[build].seen.push(seen)
}

async function mediansOf(times) {
  const { median } = await server.ssrLoadModule('/bench/statistics.ts')
  return [...times].map(([figure, builds]) => ({
    figure,
    medians: Object.fromEntries(
      Object.entries(builds).map(([build, { submitted, seen }]) => [
        build,
        { submitted: median(submitted), ...(seen.length > 0 && { seen: median(seen) }) },
      ]),
    ),
  }))
}

function checkNames(names) {
  const unknown = names.find((name) => !(name in CASES))
  if (unknown === undefined) return names
  throw new Error(
    `bench: unknown case, got "${unknown}", allowed: ${Object.keys(CASES).join(', ')}; name one of these`,
  )
}
