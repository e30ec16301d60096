// `npm run bench:walkers`: measures how much folds add to the frame time of 1,000 walking characters. See README.md.
// On software rasterisers, draws only a few characters, to check that the benchmark works.
// --renderer webgl: only one renderer. --rounds 5: number of rounds.

import { parseArgs } from 'node:util'
import { setUp } from '../scripts/lib/set-up.mjs'
import { parseRounds } from './options.mjs'

/** Characters on software rasterisers. */
const FEW = 12
const SOFTWARE = /swiftshader|llvmpipe|lavapipe|software|basic render/i

const { values } = parseArgs({
  options: { renderer: { type: 'string', multiple: true }, rounds: { type: 'string', default: '5' } },
})
const rounds = parseRounds(values.rounds)

await setUp()
// These modules import packages that `setUp` installs and builds, so they are imported after it.
const { chromiumHost } = await import('./hosts.mjs')
const { runServed, serve } = await import('./serve.mjs')

const server = await serve()
await runServed(server, async () => {
  const { checkRenderers } = await server.ssrLoadModule('/bench/case.ts')
  const { CROWD_PICTURE } = await server.ssrLoadModule('/bench/page/crowd.ts')
  const { WALKERS } = await server.ssrLoadModule('/bench/page/walkers.ts')
  const { median, spread } = await server.ssrLoadModule('/bench/statistics.ts')
  const renderers = checkRenderers(values.renderer)
  const addressOf = (file) => new URL(file, server.resolvedUrls.local[0]).href
  const host = await chromiumHost(server)
  try {
    for (const renderer of renderers) {
      const page = await host.open()
      const { width, height } = CROWD_PICTURE
      const { adapter, timing } = await page.open(renderer, width, height, addressOf('/faces/human.glb'))
      const isSoftware = SOFTWARE.test(adapter)
      const [count, plan] = isSoftware ? [FEW, { rounds: 1 }] : [WALKERS, { rounds }]
      const ratios = await page.measureWalkers(addressOf('/faces/body.glb'), count, plan)
      await page.close()
      const result = isSoftware
        ? `not measured on a software rasteriser; folds of ${count} characters were drawn`
        : `${median(ratios).toFixed(3)} of a frame without folds (quartiles ${spread(ratios).toFixed(3)} apart), timed by ${timing}`
      process.stdout.write(`${WALKERS} walking characters on ${renderer}: ${result} (${adapter})\n`)
    }
  } finally {
    await host.close()
  }
})
