// `npm run auto-sheets`: draws contact sheets of automatic wrinkles, one per region, see README.md. Names select regions.
// --out FOLDER: folder of the sheets, and of the heads with wrinkles, which later runs use again.
// FURROW_BEFORE=../checkout also draws the wrinkles of an earlier version. That checkout must be built.

import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { ensureBrowser } from '../../../scripts/lib/browser.mjs'
import { chosenNames } from '../../../scripts/lib/chosen-names.mjs'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { main } from '../../../scripts/lib/run.mjs'
import { setUp } from '../../../scripts/lib/set-up.mjs'
import { CACHE } from '../sample-heads.mjs'
import { describeSheets, drawSheets } from './draw-sheets.mjs'
import { sheetHeads, VERSIONS, wrinkledHeads } from './heads.mjs'
import { picturesOf, REGIONS, TILE } from './regions.mjs'

/** Rows of heads in an image for readers. More would be scaled down by most viewers. */
const ROWS = 4

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { out: { type: 'string', default: join(CACHE, 'sheets') } },
  })
  const regions = chosenNames('region', positionals, Object.keys(REGIONS))
  const out = resolve(values.out)
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  const heads = await sheetHeads(join(out, 'heads'))
  describe(out, heads)
  const shots = await planShots(heads, regions)
  const pathOf = await wrinkledHeads(heads, [...new Set(shots.map(({ age }) => age))], join(out, 'glb'))
  for (const version of Object.keys(VERSIONS)) {
    await drawSheets(
      out,
      shots.map(({ head, age, picture, ...shot }) => ({
        ...shot,
        version,
        picture: { ...picture, input: pathOf(version, head, age) },
      })),
    )
  }
})

function describe(out, heads) {
  const parts = Object.keys(REGIONS).flatMap((region) =>
    Array.from({ length: Math.ceil(heads.length / ROWS) }, (_, i) => {
      const firstRow = i * ROWS
      return { region, sheet: region, firstRow, rows: Math.min(ROWS, heads.length - firstRow) }
    }),
  )
  describeSheets(out, { tile: TILE, versions: { before: 'before', after: 'after' }, parts })
}

/** Returns the pictures of all sheets, in the order of the sheets. */
async function planShots(heads, regions) {
  const { headFrame } = await importSource('bench/auto/sheets/head-frame.ts')
  const frames = await Promise.all(heads.map(({ file }) => headFrame(file)))
  return regions.flatMap((region) =>
    heads.flatMap((head, i) =>
      picturesOf(REGIONS[region], frames[i]).map((shot, k) => ({
        ...shot,
        sheet: region,
        head,
        beginsRow: k === 0,
      })),
    ),
  )
}
