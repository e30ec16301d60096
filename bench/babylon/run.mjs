// `npm run bench:babylon [-- --size 3840x2160 --rounds 5 --renderer webgl]`: measures the frame time of a face in Babylon.js with and without
// wrinkles.

import { parseArgs } from 'node:util'
import { parseRounds, parseSize } from '../options.mjs'
import { launchTimed, openPage, runServed, serve } from '../serve.mjs'

const { values: options } = parseArgs({
  options: {
    size: { type: 'string', default: '800x600' },
    rounds: { type: 'string', default: '5' },
    renderer: { type: 'string', multiple: true, default: ['webgl', 'webgpu'] },
  },
})

const server = await serve()
await runServed(server, run)

async function run() {
  const { width, height } = parseSize(options.size)
  const rounds = parseRounds(options.rounds)
  const { MIN_CHANGED } = await server.ssrLoadModule('/bench/page/changed.ts')
  const { median, ratio } = await server.ssrLoadModule('/bench/statistics.ts')
  const browser = await launchTimed(server)
  try {
    for (const renderer of options.renderer) {
      const page = await openPage(server, browser, '/bench/babylon/page.html', 'timeBabylon')
      const { adapter, plain, furrow, changed } = await page.evaluate(
        (args) => window.timeBabylon(...args),
        [renderer, width, height, rounds],
      )
      await page.close()
      if (changed < MIN_CHANGED)
        throw new Error(
          `bench: Babylon.js shows no wrinkles on ${renderer}, got ${changed} of the pixels changed, allowed: at least ${MIN_CHANGED}`,
        )
      const [plainTime, furrowTime] = [plain, furrow].map((times) => `${median(times).toFixed(2)} ms`)
      process.stdout.write(
        `${renderer}, ${adapter}: plain ${plainTime}, furrow ${furrowTime}, ratio ${ratio(furrow, plain).toFixed(3)}\n`,
      )
    }
  } finally {
    await browser.close()
  }
}
