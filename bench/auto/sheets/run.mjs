// `npm run auto-sheets`: draws contact sheets of automatic wrinkles, one per region, see README.md. Names select regions.
// --out FOLDER: folder of the sheets, and of the heads with wrinkles, which later runs use again.
// FURROW_BEFORE=../checkout also draws the wrinkles of an earlier version. That checkout must be built.

import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { drawPictures } from '../../../scripts/figures/draw.mjs'
import { writeSheet } from '../../../scripts/figures/write.mjs'
import { ensureBrowser } from '../../../scripts/lib/browser.mjs'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { Failure, main, say } from '../../../scripts/lib/run.mjs'
import { setUp } from '../../../scripts/lib/set-up.mjs'
import { CACHE } from '../sample-heads.mjs'
import { sheetHeads, VERSIONS, wrinkledHeads } from './heads.mjs'
import { picturesOf, REGIONS, TILE } from './regions.mjs'

/** Pictures are shown complete. */
const CROP = { left: 0, top: 0, width: TILE, height: TILE }

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { out: { type: 'string', default: join(CACHE, 'sheets') } },
  })
  const unknown = positionals.find((name) => !(name in REGIONS))
  const allowed = Object.keys(REGIONS)
  if (unknown !== undefined)
    throw new Failure(`unknown region, got "${unknown}", allowed: ${allowed.join(', ')}; name one of these`)
  const regions = positionals.length > 0 ? positionals : allowed
  const out = resolve(values.out)
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const heads = await sheetHeads(join(out, 'heads'))
  const shots = await planShots(heads, regions)
  const pathOf = await wrinkledHeads(heads, [...new Set(shots.map(({ age }) => age))], join(out, 'glb'))
  for (const version of Object.keys(VERSIONS)) {
    const requests = shots.map(({ head, age, picture }) => ({
      ...picture,
      input: pathOf(version, head, age),
    }))
    const pictures = await drawPictures(requests)
    for (const region of regions) {
      const file = join(out, `${region}-${version}.jpg`)
      await writeSheet(
        pictures.flatMap((picture, i) =>
          shots[i].region === region ? { ...picture, ...shots[i].place } : [],
        ),
        file,
      )
      say(file)
    }
  }
})

/** Returns the pictures of all sheets, in the order of the sheets. */
async function planShots(heads, regions) {
  const { headFrame } = await importSource('bench/auto/sheets/head-frame.ts')
  const frames = await Promise.all(heads.map(({ file }) => headFrame(file)))
  return regions.flatMap((region) =>
    heads.flatMap((head, i) =>
      picturesOf(REGIONS[region], frames[i]).map((shot, k) => ({
        ...shot,
        region,
        head,
        place: { crop: CROP, beginsRow: k === 0 },
      })),
    ),
  )
}
