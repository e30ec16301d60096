// `npm run figures`: renders the figures of the README and the docs into docs/figures/. `-- ktx2` renders one figure.
// `-- examples` renders the pictures of all examples, and `-- examples/age` the picture of one.
// Portraits go to faces/, which the studio shows.
// FURROW_BEFORE=../checkout adds the automatic wrinkles of an earlier version to the close-ups. That checkout must be
// built.

import { existsSync } from 'node:fs'
import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { drawPictures } from './figures/draw.mjs'
import { isExamplePicture, writeExamplePictures } from './figures/examples.mjs'
import { FACE, FACES, SCAN } from './figures/faces.mjs'
import { FIGURES, FORMATS, MOVING } from './figures/list.mjs'
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
    const folder = name.startsWith('portraits/') ? 'faces' : 'docs/figures'
    const file = `${folder}/${name}.${FORMATS[name] ?? 'png'}`
    if (MOVING[name]) await writeMoving(shown, MOVING[name](), join(ROOT, file))
    else await writeSheet(shown, join(ROOT, file))
    say(file)
  }
})

/** Selects figures by name. Without names, selects all figures. */
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
  const folder = await mkdtemp(join(tmpdir(), 'furrow-figures-'))
  try {
    const files = await makeFaces(shots, folder)
    const requests = shots.map(({ crop, scale, face, beginsRow, ...picture }) => {
      return { input: files.get(face) ?? FACE, ...picture }
    })
    return await drawPictures(requests)
  } finally {
    await rm(folder, { recursive: true })
  }
}

/** Writes the faces (see `FACES`) that the pictures need. Returns their paths by name. */
async function makeFaces(shots, folder) {
  const files = new Map()
  for (const { face } of shots) {
    if (face === undefined || files.has(face)) continue
    files.set(face, join(folder, `${face}.glb`))
    await FACES[face](files.get(face))
  }
  return files
}
