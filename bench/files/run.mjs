// `node bench/files/run.mjs [--rounds 15] [--json FILE]`: measures the time to pack and to load the wrinkles of a face, with and without the time of
// image codecs. Run `npm run build` first.

import { writeFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { parseArgs } from 'node:util'
import { launchBrowser } from '../../packages/cli/dist/browser.js'
import { withBar } from '../../packages/cli/dist/progress.js'
import { openPage, ROOT, serve } from '../serve.mjs'
import { packOnce } from './pack.mjs'

const { values: options } = parseArgs({
  options: { rounds: { type: 'string', default: '15' }, json: { type: 'string' } },
})
const rounds = Number(options.rounds)

const packed = await withBar('pack', async (progress) => {
  const times = []
  // The first round only warms up.
  for (let i = 0; i <= rounds; i++) {
    const time = await packOnce(`${ROOT}faces`)
    if (i > 0) times.push(time)
    progress(i + 1, rounds + 1)
  }
  return times
})
const server = await serve()
const { median } = await server.ssrLoadModule('/bench/statistics.ts')
const loaded = await load().finally(() => server.close())
const rows = [
  row(
    'pack',
    packed,
    ({ total }) => total,
    ({ codecs }) => codecs,
  ),
  row(
    'load',
    loaded,
    (time) => time.with - time.without,
    ({ images }) => images,
  ),
]
const text = (ms) => `${ms.toFixed(0)} ms`.padStart(16)
process.stdout.write(`${cpus()[0].model}, ${cpus().length} cores, medians of ${rounds} rounds\n`)
process.stdout.write(
  `${['', 'wrinkles', 'images', 'without images'].map((head) => head.padStart(16)).join('')}\n`,
)
for (const { name, wrinkles, images, withoutImages } of rows) {
  process.stdout.write(`${name.padStart(16)}${[wrinkles, images, withoutImages].map(text).join('')}\n`)
}
if (options.json) writeFileSync(options.json, `${JSON.stringify(rows, null, 2)}\n`)

/** Measures loading in a browser. Vite serves the packages' sources. */
async function load() {
  const browser = await launchBrowser()
  try {
    const page = await openPage(server, browser, '/bench/files/page.html', 'measure')
    return await page.evaluate((count) => window.measure(count), rounds)
  } finally {
    await browser.close()
  }
}

function row(name, times, total, images) {
  return {
    name,
    wrinkles: median(times.map(total)),
    images: median(times.map(images)),
    withoutImages: median(times.map((time) => total(time) - images(time))),
  }
}
