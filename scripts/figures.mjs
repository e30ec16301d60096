// Remakes the pictures of the README into docs/figures/: `npm run figures`, or some: `npm run figures -- hero`.
// 8, 9 and 10 are the paper's.

import { mkdir, rename } from 'node:fs/promises'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { Failure, main, ROOT, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

const FOLDER = join(ROOT, 'docs/figures')
const FACE = join(ROOT, 'faces/human.glb')

/** Pixels between two pictures of a figure. */
const GAP = 8

/** The face fills the frame: of a larger picture only this is kept. */
const PORTRAIT = { width: 900, height: 1050, crop: { left: 180, top: 50, width: 540, height: 720 } }
const EYE = {
  width: 1600,
  height: 1200,
  view: 'close',
  crop: { left: 700, top: 330, width: 720, height: 540 },
}

/** Each figure is a row of pictures, from left to right. */
const FIGURES = {
  'figure-8': [
    { ...PORTRAIT, expression: 'neutral' },
    { ...PORTRAIT, expression: 'surprised' },
  ],
  'figure-9': [
    { ...PORTRAIT, expression: 'leftBrow' },
    { ...PORTRAIT, expression: 'rightBrow' },
  ],
  'figure-10': [
    { ...EYE, activations: { crowsFeetLeft: 1 }, targets: { cheekSquintLeft: 1, eyeSquintLeft: 0.6 } },
  ],
  hero: [
    { ...PORTRAIT, expression: 'neutral', mode: 'off' },
    { ...PORTRAIT, expression: 'surprised' },
    { ...PORTRAIT, expression: 'happy' },
  ],
}

await main(async () => {
  const figures = wanted(process.argv.slice(2))
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const { renderPictures } = await import('../packages/cli/dist/render/render-pictures.js')
  const requests = Object.values(figures)
    .flat()
    .map(({ crop, ...picture }) => ({ input: FACE, ...picture }))
  const pictures = await withBar((progress) => renderPictures(requests, progress))
  await mkdir(FOLDER, { recursive: true })
  for (const [name, row] of Object.entries(figures)) {
    const parts = row.map(({ crop }) => ({ ...pictures.shift(), crop }))
    await compose(parts, join(FOLDER, `${name}.png`))
    say(`docs/figures/${name}.png`)
  }
})

/** The figures of these names; all of them where there are none. */
function wanted(names) {
  const unknown = names.find((name) => !(name in FIGURES))
  if (unknown === undefined)
    return names.length > 0 ? Object.fromEntries(names.map((name) => [name, FIGURES[name]])) : FIGURES
  const allowed = Object.keys(FIGURES).join(', ')
  throw new Failure(`unknown figure, got "${unknown}", allowed: ${allowed}; name one of these`)
}

async function withBar(work) {
  const { SingleBar } = await import('cli-progress')
  const bar = new SingleBar({
    format: 'figures {bar} {value}/{total}',
    stream: process.stderr,
    clearOnComplete: true,
  })
  let started = false
  try {
    return await work((done, total) => {
      if (!started) bar.start(total, 0)
      started = true
      bar.update(done)
    })
  } finally {
    bar.stop()
  }
}

/** Sets pictures of one height side by side; what is between them is transparent. */
async function compose(pictures, file) {
  const { default: sharp } = await import('sharp')
  let left = 0
  const layers = []
  for (const { width, height, pixels, crop } of pictures) {
    const input = await sharp(pixels, { raw: { width, height, channels: 4 } })
      .extract(crop)
      .png()
      .toBuffer()
    layers.push({ input, left, top: 0 })
    left += crop.width + GAP
  }
  const background = { r: 0, g: 0, b: 0, alpha: 0 }
  const canvas = { width: left - GAP, height: pictures[0].crop.height, channels: 4, background }
  await sharp({ create: canvas }).composite(layers).png({ compressionLevel: 9 }).toFile(`${file}.tmp`)
  await rename(`${file}.tmp`, file)
}
