// Remakes the pictures of the README and the docs into docs/figures/: `npm run figures`, or some: `npm run figures -- hero`.
// 8, 9 and 10 are the paper's.

import { mkdir, mkdtemp, rename, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { shootPages } from './lib/pages.mjs'
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

const BROW = {
  width: 1600,
  height: 1200,
  view: 'close',
  targets: { browOuterUpLeft: 1, browInnerUp: 0.4 },
  crop: { left: 480, top: 130, width: 720, height: 480 },
}
const FOREHEAD = { ...PORTRAIT, expression: 'surprised', crop: { ...PORTRAIT.crop, height: 480 } }

/** An example page's own picture. */
const PAGE = { width: 720, height: 900, crop: { left: 135, top: 20, width: 450, height: 540 } }
/** WebGPU's canvas has no picture to take without a graphics card; on WebGL 2 the same page shows the same. */
const CHEEKS = { width: 1100, height: 1300, crop: { left: 300, top: 400, width: 500, height: 500 } }
const HAND = { width: 900, height: 900, crop: { left: 190, top: 130, width: 490, height: 660 } }
const NECK = { width: 900, height: 900, crop: { left: 270, top: 130, width: 450, height: 660 } }
const BASIC_EXPRESSIONS = ['neutral', 'happiness', 'surprise', 'anger', 'sadness', 'fear', 'disgust']

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
  ktx2: [
    { ...BROW, face: 'images' },
    { ...BROW, face: 'arrays' },
  ],
  muscles: BASIC_EXPRESSIONS.map((name) => ({ ...PAGE, page: `muscles.html?expression=${name}` })),
  joints: [
    { ...HAND, page: 'joints.html?fist=0' },
    { ...HAND, page: 'joints.html?fist=1&smooth' },
    { ...HAND, page: 'joints.html?fist=1' },
    { ...NECK, page: 'joints.html?model=neck&turn=1&smooth' },
    { ...NECK, page: 'joints.html?model=neck&turn=1' },
  ],
  age: [20, 40, 60, 80].map((years) => ({ ...PAGE, page: `age.html?age=${years}` })),
  normals: ['none', 'baked', 'recomputed'].map((remedy) => ({
    ...CHEEKS,
    page: `normals.html?webgl&remedy=${remedy}&cheekPuff=1&mouthPucker=0.7`,
  })),
  transform: [FOREHEAD, { ...FOREHEAD, face: 'lossless' }, { ...FOREHEAD, face: 'lossy' }],
}

/** The face in other forms, and what makes them. */
const FACES = {
  images: (file) => pack(file),
  arrays: (file) => pack(file, '--ktx2'),
  lossless: (file) => shrink(file, true),
  lossy: (file) => shrink(file, false),
}

await main(async () => {
  const figures = wanted(process.argv.slice(2))
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const { renderPictures } = await import('../packages/cli/dist/render/render-pictures.js')
  const parts = Object.values(figures).flat()
  const rows = parts.filter(({ page }) => page === undefined)
  const folder = await mkdtemp(join(tmpdir(), 'furrow-figures-'))
  let pictures
  try {
    const files = await makeFaces(rows, folder)
    const requests = rows.map(({ crop, face, ...picture }) => ({
      input: files.get(face) ?? FACE,
      ...picture,
    }))
    pictures = requests.length > 0 ? await withBar((progress) => renderPictures(requests, progress)) : []
  } finally {
    await rm(folder, { recursive: true })
  }
  const pages = await shootPages(parts.filter(({ page }) => page !== undefined))
  await mkdir(FOLDER, { recursive: true })
  for (const [name, row] of Object.entries(figures)) {
    const shown = row.map(({ page, crop }) => ({ ...(page ? pages : pictures).shift(), crop }))
    await compose(shown, join(FOLDER, `${name}.png`))
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

/** Makes those of `FACES` that some pictures are of; returns their files by name. */
async function makeFaces(pictures, folder) {
  const files = new Map()
  for (const { face } of pictures) {
    if (face === undefined || files.has(face)) continue
    files.set(face, join(folder, `${face}.glb`))
    await FACES[face](files.get(face))
  }
  return files
}

async function pack(file, ...options) {
  const { packCommand } = await import('../packages/cli/dist/commands/pack.js')
  const words = [join(ROOT, 'faces/human'), '--face', FACE, '--size', '512', '-o', file, ...options]
  await packCommand.parseAsync(words, { from: 'user' })
}

async function shrink(file, lossless) {
  const { shrinking, transformFile } = await import('./lib/transform.mjs')
  await transformFile(FACE, file, shrinking(lossless))
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
