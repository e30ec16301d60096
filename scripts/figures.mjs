// Renders the pictures of the README and the docs into docs/figures/: `npm run figures`, or only some: `npm run figures -- hero`.
// Figures 8, 9 and 10 are the paper's.

import { existsSync } from 'node:fs'
import { mkdir, mkdtemp, rename, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { shootPages } from './lib/pages.mjs'
import { Failure, main, ROOT, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

const FOLDER = join(ROOT, 'docs/figures')
const FACE = join(ROOT, 'faces/human.glb')
/** A scanned face that is not in this repository; without it, its figure is not rendered. */
const SCAN = join(ROOT, '../shared/real-face/ict-face.glb')

/** Pixels between the pictures of a figure. */
const GAP = 8

/** Crops of larger pictures, in which the face fills the frame. */
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

/** Pictures of example pages. */
const PAGE = { width: 720, height: 900, crop: { left: 135, top: 20, width: 450, height: 540 } }
/** Drawn on WebGL 2, since a WebGPU canvas cannot be captured without a GPU. */
const CHEEKS = { width: 1100, height: 1300, crop: { left: 300, top: 400, width: 500, height: 500 } }
const HAND = { width: 900, height: 900, crop: { left: 190, top: 130, width: 490, height: 660 } }
const NECK = { width: 900, height: 900, crop: { left: 270, top: 130, width: 450, height: 660 } }
const BASIC_EXPRESSIONS = ['neutral', 'happiness', 'surprise', 'anger', 'sadness', 'fear', 'disgust']

const both = (name, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })

/** Poses that show automatic wrinkles. */
const POSES = [
  { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.8), jawOpen: 0.25 },
  { ...both('browDown'), ...both('eyeSquint', 0.3), ...both('mouthPress', 0.4) },
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) },
  { ...both('noseSneer'), ...both('mouthUpperUp', 0.5), ...both('browDown', 0.4) },
  { ...both('eyeSquint'), ...both('cheekSquint') },
  { mouthPucker: 1 },
  { browOuterUpLeft: 1, browInnerUp: 0.2 },
  { mouthSmileRight: 1, cheekSquintRight: 0.8 },
]
const AGES = [30, 50, 70]

/** A row without wrinkles, and one for each age. */
const agesOf = (name, picture) =>
  [undefined, ...AGES].flatMap((age) =>
    POSES.map((targets, i) => ({
      ...picture,
      targets,
      face: `${name}${age ?? AGES[0]}`,
      mode: age === undefined ? 'off' : 'default',
      beginsRow: i === 0,
    })),
  )

/** The shipped face and two darker ones: what its base colour is multiplied by, in linear sRGB. */
const SKINS = { light: [1, 1, 1], medium: [0.62, 0.55, 0.48], dark: [0.18, 0.15, 0.13] }
const FLUSHED = { width: 760, height: 760, crop: { left: 250, top: 170, width: 260, height: 380 } }
const FLUSHES = [
  { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8) },
  { ...both('noseSneer'), ...both('browDown', 0.8) },
]

/** A row for each skin: each expression without blood and with it. */
const bloodOfSkins = () =>
  Object.keys(SKINS).flatMap((skin) =>
    FLUSHES.flatMap((targets, i) =>
      ['Pale', ''].map((end, k) => ({
        ...FLUSHED,
        targets,
        face: `${skin}${end}`,
        beginsRow: i === 0 && k === 0,
      })),
    ),
  )

/** Figures of many faces are stored as JPEG. */
const JPEG_FIGURES = ['auto-human', 'auto-scan', 'blood']

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
  'auto-human': agesOf('human', {
    width: 630,
    height: 540,
    crop: { left: 157, top: 36, width: 315, height: 374 },
  }),
  'auto-scan': agesOf('scan', {
    mesh: 'face',
    width: 630,
    height: 540,
    crop: { left: 157, top: 8, width: 315, height: 374 },
  }),
  blood: bloodOfSkins(),
  transform: [FOREHEAD, { ...FOREHEAD, face: 'lossless' }, { ...FOREHEAD, face: 'lossy' }],
}

/** Variants of the faces, and the functions that write them. */
const FACES = {
  images: (file) => pack(file),
  arrays: (file) => pack(file, '--ktx2'),
  lossless: (file) => shrink(file, true),
  lossy: (file) => shrink(file, false),
  ...Object.fromEntries(
    Object.entries(SKINS).flatMap(([name, factor]) => [
      [name, (file) => tint(file, factor, false)],
      [`${name}Pale`, (file) => tint(file, factor, true)],
    ]),
  ),
  ...Object.fromEntries(
    AGES.flatMap((age) => [
      [`human${age}`, (file) => auto(FACE, file, age)],
      [`scan${age}`, (file) => auto(SCAN, file, age)],
    ]),
  ),
}

await main(async () => {
  const figures = selectFigures(process.argv.slice(2))
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const { renderPictures } = await import('../packages/cli/dist/render/render-pictures.js')
  const parts = Object.values(figures).flat()
  const rows = parts.filter(({ page }) => page === undefined)
  const folder = await mkdtemp(join(tmpdir(), 'furrow-figures-'))
  let pictures
  try {
    const files = await makeFaces(rows, folder)
    const requests = rows.map(({ crop, face, beginsRow, ...picture }) => ({
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
    const cropped = row.map(({ page, crop, beginsRow }) => ({
      ...(page ? pages : pictures).shift(),
      crop,
      beginsRow,
    }))
    const file = `${name}.${JPEG_FIGURES.includes(name) ? 'jpg' : 'png'}`
    await compose(cropped, join(FOLDER, file))
    say(`docs/figures/${file}`)
  }
})

/** Figures of these names; all of them if there are no names. */
function selectFigures(names) {
  const unknown = names.find((name) => !(name in FIGURES))
  if (unknown === undefined)
    return Object.fromEntries(
      (names.length > 0 ? names : Object.keys(FIGURES))
        .filter((name) => name !== 'auto-scan' || existsSync(SCAN))
        .map((name) => [name, FIGURES[name]]),
    )
  const allowed = Object.keys(FIGURES).join(', ')
  throw new Failure(`unknown figure, got "${unknown}", allowed: ${allowed}; name one of these`)
}

/** Writes the `FACES` that appear in some pictures; returns their files by name. */
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
  const args = [join(ROOT, 'faces/human'), '--face', FACE, '--size', '512', '-o', file, ...options]
  await packCommand.parseAsync(args, { from: 'user' })
}

async function auto(face, file, age) {
  const { autoCommand } = await import('../packages/cli/dist/commands/auto.js')
  await autoCommand.parseAsync([face, '-o', file, '--age', String(age), '--replace'], { from: 'user' })
}

/** The shipped face with automatic wrinkles, made once. */
let wrinkled

/** @param isPale whether the blood stays as it is at rest. */
async function tint(file, factor, isPale) {
  const { transformFile } = await import('./lib/transform.mjs')
  if (!wrinkled) await auto(FACE, (wrinkled = `${file}.auto.glb`), 45)
  await transformFile(wrinkled, file, [
    (document) => {
      for (const material of document.getRoot().listMaterials()) {
        const wrinkles = material.getExtension('FURROW_wrinkle_maps')
        if (!wrinkles) continue
        material.setBaseColorFactor([...factor, 1])
        if (isPale) for (const layer of wrinkles.listLayers()) layer.setBloodAmplitude(0)
      }
    },
  ])
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

/** Arranges pictures of equal size in rows. The gaps are transparent, or white in JPEG. */
async function compose(pictures, file) {
  const { default: sharp } = await import('sharp')
  let [left, top, width] = [0, 0, 0]
  const layers = []
  for (const [i, { beginsRow, crop, pixels, ...size }] of pictures.entries()) {
    if (i === 0 || beginsRow) {
      left = 0
      if (i > 0) top += GAP + crop.height
    }
    const input = await sharp(pixels, { raw: { width: size.width, height: size.height, channels: 4 } })
      .extract(crop)
      .png()
      .toBuffer()
    layers.push({ input, left, top })
    left += crop.width + GAP
    width = Math.max(width, left - GAP)
  }
  const background = { r: 255, g: 255, b: 255, alpha: 0 }
  const canvas = { width, height: top + pictures[0].crop.height, channels: 4, background }
  const image = sharp(await sharp({ create: canvas }).composite(layers).png().toBuffer())
  const isJpeg = file.endsWith('.jpg')
  const encoded = isJpeg
    ? image.flatten({ background: '#fff' }).jpeg({ quality: 88, mozjpeg: true })
    : image.png({ compressionLevel: 9 })
  await encoded.toFile(`${file}.tmp`)
  await rename(`${file}.tmp`, file)
}
