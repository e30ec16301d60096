// Times a face in Babylon.js with wrinkles against the plain one: `npm run bench:babylon [-- --size 3840x2160 --rounds 5 --renderer webgl]`.

import { parseArgs } from 'node:util'
import { openPage, runServed, serve } from '../serve.mjs'

const { values: options } = parseArgs({
  options: {
    size: { type: 'string', default: '800x600' },
    rounds: { type: 'string', default: '5' },
    renderer: { type: 'string', multiple: true, default: ['webgl', 'webgpu'] },
  },
})

/** Smallest fraction of pixels that wrinkles must change: what shows none would be fast. */
const MIN_CHANGED = 0.005
const server = await serve()
await runServed(server, run)

async function run() {
  const [width, height] = options.size.split('x').map(Number)
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const { median, ratio } = await server.ssrLoadModule('/bench/statistics.ts')
  const browser = await launchBrowser(['--enable-webgpu-developer-features'])
  try {
    for (const renderer of options.renderer) {
      const page = await openPage(server, browser, '/bench/babylon/page.html', 'timeBabylon')
      const { adapter, plain, furrow, changed } = await page.evaluate(
        (args) => window.timeBabylon(...args),
        [renderer, width, height, Number(options.rounds)],
      )
      await page.close()
      if (changed < MIN_CHANGED)
        throw new Error(`bench: Babylon.js shows no wrinkles on ${renderer}: ${changed} of the pixels differ`)
      const [own, wrinkled] = [plain, furrow].map((rounds) => `${median(rounds).toFixed(2)} ms`)
      process.stdout.write(
        `${renderer}, ${adapter}: plain ${own}, furrow ${wrinkled}, ratio ${ratio(furrow, plain).toFixed(3)}\n`,
      )
    }
  } finally {
    await browser.close()
  }
}
