// `npm run bench`: measures the frame time of a face with wrinkles, by several techniques, and without wrinkles. See README.md.

import { writeFile } from 'node:fs/promises'
import { parseArgs } from 'node:util'
import { setUp } from '../scripts/lib/set-up.mjs'
import { parseRounds, parseSize } from './options.mjs'

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    rounds: { type: 'string' },
    json: { type: 'string' },
    size: { type: 'string', default: '800x600' },
    renderer: { type: 'string', multiple: true },
    node: { type: 'boolean', default: false },
  },
})

await setUp()
// These modules import packages that `setUp` installs and builds, so they are imported after it.
const { measureCpu, measureCrowdCpu, measureMinimalCpu } = await import('./cpu.mjs')
const { chromiumHost, nodeHost } = await import('./hosts.mjs')
const { runServed, serve } = await import('./serve.mjs')
const { measureSizes } = await import('./size.mjs')

const server = await serve()
await runServed(server, run)
// Without this call, Dawn would keep the process running.
if (options.node) process.exit()

async function run() {
  const { checkRenderers, listCases, PLANS } = await server.ssrLoadModule('/bench/case.ts')
  const { toLine } = await server.ssrLoadModule('/bench/line.ts')
  const { toResults, toTable } = await server.ssrLoadModule('/bench/report.ts')
  const { CROWD_KINDS, CROWD_PICTURE } = await server.ssrLoadModule('/bench/page/crowd.ts')
  const { median, spread } = await server.ssrLoadModule('/bench/statistics.ts')
  const { kilobytes } = await server.ssrLoadModule('/packages/files/src/index.ts')
  const { withBar } = await server.ssrLoadModule('/packages/cli/src/progress.ts')
  const renderers = checkRenderers(options.renderer, options.node ? ['webgpu'] : undefined)
  const { width, height } = parseSize(options.size)
  const cases = listCases(options.quick)
  const { rounds } = options.quick ? PLANS.quick : PLANS.full
  const plan = { rounds: options.rounds === undefined ? rounds : parseRounds(options.rounds) }
  const host = await (options.node ? nodeHost : chromiumHost)(server)
  const face = new URL('/faces/human.glb', server.resolvedUrls.local[0]).href
  const crowds = []
  const updates = []
  const results = await withBar('bench', async (progress) => {
    const found = []
    for (const [i, renderer] of renderers.entries()) {
      const page = await host.open()
      const setup = { width, height, renderer, ...(await page.open(renderer, width, height, face)) }
      for (const [k, benchCase] of cases.entries()) {
        found.push(...toResults(benchCase, setup, await page.measure(benchCase, plan)))
        const [done, total] = [i * cases.length + k + 1, renderers.length * cases.length]
        progress(done, total)
        // `withBar` shows progress only on a terminal.
        if (!process.stderr.isTTY) process.stderr.write(`bench: ${done} of ${total} cases\n`)
      }
      updates.push([renderer, await page.measureUpdates(plan)])
      await page.close()
      const crowd = await host.open()
      await crowd.open(renderer, CROWD_PICTURE.width, CROWD_PICTURE.height, face)
      for (const kind of CROWD_KINDS) crowds.push([renderer, kind, await crowd.measureCrowd(kind, plan)])
      await crowd.close()
    }
    return found
  }).finally(() => host.close())
  if (options.json) await writeFile(options.json, `${JSON.stringify(results, null, 2)}\n`)
  const adapters = new Set(results.map(({ adapter, timing }) => `${adapter}, timed by ${timing}`))
  process.stdout.write(`${[...adapters].join('\n')}\n${toTable(results)}\n\n`)
  for (const [renderer, { faces, pixels, areaSize }, fractions] of crowds) {
    const [percent, range] = [median, spread].map((statistic) => (100 * statistic(fractions)).toFixed(2))
    process.stdout.write(
      `crowd: ${percent}% (quartiles ${range} apart) of a frame with ${faces} faces of ${pixels} pixels on ${renderer}, influence maps of ${areaSize} x ${areaSize}\n`,
    )
  }
  for (const [renderer, { region, full }] of updates) {
    process.stdout.write(
      `updates: ${region.toFixed(1)} ms for 64 x 64 texels of a normal map of 1024 x 1024 on ${renderer}, ${full.toFixed(1)} ms for all\n`,
    )
  }
  for (const allTypes of [false, true]) {
    const { targets, areas, microseconds, bytes } = measureCpu(allTypes)
    process.stdout.write(
      `CPU: ${microseconds.toFixed(1)} microseconds and ${bytes.toFixed(1)} bytes per frame, one face, ${targets} blendshapes, ${areas} areas${allTypes ? ', every driver type' : ''}\n`,
    )
  }
  for (const { faces } of CROWD_KINDS) {
    const { moving, still, stillAmongMoving } = measureCrowdCpu(faces)
    const minimal = measureMinimalCpu(faces)
    process.stdout.write(
      `CPU: microseconds per frame and face of ${faces}: ${moving.toFixed(1)} moving, ${still.toFixed(2)} still, ${stillAmongMoving.toFixed(2)} still while one in a hundred moves; minimal implementation: ${minimal.moving.toFixed(1)} moving, ${minimal.still.toFixed(2)} still\n`,
    )
  }
  for (const [name, { gzip, brotli }] of Object.entries(await measureSizes())) {
    process.stdout.write(`download: ${name}: ${kilobytes(gzip)} by gzip, ${kilobytes(brotli)} by Brotli\n`)
  }
  const line = toLine(results, { browser: host.name, date: new Date() })
  process.stdout.write(`\nto share these results, paste this line into an issue:\n\n${line}\n`)
}
