// `npm run body-sheets`: draws contact sheets of folds from joints, one per body, see README.md. Names select bodies.
// --out FOLDER: folder of the sheets, and of the bodies with folds, which later runs use again.

import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { ensureBrowser } from '../../../scripts/lib/browser.mjs'
import { chosenNames } from '../../../scripts/lib/chosen-names.mjs'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { main, ROOT } from '../../../scripts/lib/run.mjs'
import { setUp } from '../../../scripts/lib/set-up.mjs'
import { CACHE } from '../sample-heads.mjs'
import { describeSheets, drawSheets } from '../sheets/draw-sheets.mjs'
import { wrinkleFiles } from '../sheets/wrinkle-files.mjs'
import { BODIES, bodyFiles } from './bodies.mjs'
import { picturesOf, REGIONS, TILE } from './regions.mjs'

/** Titles of the versions of a sheet, and how the page draws them. */
const VERSIONS = {
  without: { title: 'without folds', mode: 'off', relief: 'off' },
  with: { title: 'with folds', mode: 'default', relief: 'on' },
}

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { out: { type: 'string', default: join(CACHE, 'body-sheets') } },
  })
  const bodies = chosenNames('body', positionals, Object.keys(BODIES))
  const out = resolve(values.out)
  await setUp()
  process.env.FURROW_CHROMIUM = await ensureBrowser()
  describe(out)
  const folder = join(out, 'glb')
  const files = await bodyFiles(folder)
  // `furrow auto` refuses a robot, because no part of it is skin or cloth. A unit test ensures this.
  const folded = bodies.filter((body) => body !== 'robot')
  const options = ['--replace']
  const jobs = folded.map((body) => ({ name: `${body}-with`, input: files[body], root: ROOT, options }))
  const paths = await wrinkleFiles(jobs, folder)
  for (const body of bodies)
    await drawSheets(out, await shotsOf(body, paths.get(`${body}-with`) ?? files[body]))
})

function describe(out) {
  const parts = Object.entries(BODIES).flatMap(([body, meshes]) =>
    Object.keys(meshes).map((region, row) => ({
      region: `${body} ${region}`,
      sheet: body,
      firstRow: row,
      rows: 1,
    })),
  )
  const titles = Object.entries(VERSIONS).map(([version, { title }]) => [version, title])
  describeSheets(out, { tile: TILE, versions: Object.fromEntries(titles), parts })
}

/** Returns the pictures of a body. Both versions of a mesh follow each other, so that they share a page. */
async function shotsOf(body, input) {
  const { bodyFrame } = await importSource('bench/auto/bodies/body-frame.ts')
  const frame = await bodyFrame(input)
  return Object.entries(BODIES[body]).flatMap(([region, mesh]) =>
    Object.entries(VERSIONS).flatMap(([version, { mode, relief }]) =>
      picturesOf(REGIONS[region], frame).map((picture, column) => ({
        sheet: body,
        version,
        beginsRow: column === 0,
        picture: { ...picture, input, mesh, mode, relief },
      })),
    ),
  )
}
