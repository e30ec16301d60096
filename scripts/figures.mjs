// `npm run figures`: renders the README's and the docs' pictures into docs/figures/. `-- ktx2` selects figures. `-- examples` takes the
// gallery's pictures, `-- examples/age` one of them.
// FURROW_BEFORE=../checkout adds the faces and automatic wrinkles of an earlier, built version to the close-ups.

import { existsSync } from 'node:fs'
import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { isExamplePicture, writeExamplePictures } from './figures/examples.mjs'
import { FACE, FACES, SCAN } from './figures/faces.mjs'
import { FIGURES, FORMATS } from './figures/list.mjs'
import { MOVING, movingFrames } from './figures/moving.mjs'
import { writeMoving, writeSheet } from './figures/write.mjs'
import { ensureBrowser } from './lib/browser.mjs'
import { shootPages } from './lib/pages.mjs'
import { Failure, main, ROOT, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  const names = process.argv.slice(2)
  const examples = names.filter(isExamplePicture)
  const figures = selectFigures(names)
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  if (names.length === 0 || examples.length > 0) await writeExamplePictures(examples)
  const parts = Object.values(figures).flat()
  const pictures = await renderFaces(parts.filter(({ page }) => page === undefined))
  const pages = await shootPages(parts.filter(({ page }) => page !== undefined))
  for (const [name, row] of Object.entries(figures)) {
    const shown = row.map(({ page, crop, scale, beginsRow }) => ({
      ...(page ? pages : pictures).shift(),
      crop,
      scale,
      beginsRow,
    }))
    const file = `docs/figures/${name}.${FORMATS[name] ?? 'png'}`
    if (name === MOVING) await writeMoving(shown, movingFrames(), join(ROOT, file))
    else await writeSheet(shown, join(ROOT, file))
    say(file)
  }
})

/** Selects figures by name, all by default. */
function selectFigures(names) {
  const unknown = names.find((name) => !(name in FIGURES) && !isExamplePicture(name))
  if (unknown === undefined)
    return Object.fromEntries(
      (names.length > 0 ? names : Object.keys(FIGURES))
        .filter((name) => name in FIGURES && (!name.includes('scan') || existsSync(SCAN)))
        .map((name) => [name, FIGURES[name]]),
    )
  const allowed = ['examples', ...Object.keys(FIGURES)].join(', ')
  throw new Failure(`unknown figure, got "${unknown}", allowed: ${allowed}; name one of these`)
}

async function renderFaces(shots) {
  if (shots.length === 0) return []
  const { renderPictures } = await import('../packages/cli/dist/render/render-pictures.js')
  const folder = await mkdtemp(join(tmpdir(), 'furrow-figures-'))
  try {
    const files = await makeFaces(shots, folder)
    // Consecutive pictures of one face share a page.
    const order = [...shots.keys()].sort((a, b) => compareNames(shots[a].face, shots[b].face) || a - b)
    const requests = order.map((i) => {
      const { crop, scale, face, beginsRow, ...picture } = shots[i]
      return { input: files.get(face) ?? FACE, ...picture }
    })
    const drawn = await withBar((progress) => renderPictures(requests, progress))
    const pictures = []
    for (const [k, i] of order.entries()) pictures[i] = drawn[k]
    return pictures
  } finally {
    await rm(folder, { recursive: true })
  }
}

function compareNames(a = '', b = '') {
  return a < b ? -1 : Number(a > b)
}

/** Writes the `FACES` that the pictures show. Returns their paths by name. */
async function makeFaces(shots, folder) {
  const files = new Map()
  for (const { face } of shots) {
    if (face === undefined || files.has(face)) continue
    files.set(face, join(folder, `${face}.glb`))
    await FACES[face](files.get(face))
  }
  return files
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
