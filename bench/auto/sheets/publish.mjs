// `npm run auto-sheets:publish -- --from FOLDER`: writes the sheets of both versions side by side, earlier wrinkles on the left, to
// docs/figures/auto.

import { existsSync, mkdirSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { GAP } from '../../../scripts/figures/write.mjs'
import { Failure, main, ROOT, say } from '../../../scripts/lib/run.mjs'
import { CACHE } from '../sample-heads.mjs'
import { REGIONS } from './regions.mjs'

/** Width of one sheet, pixels. */
const WIDTH = 1000

await main(async () => {
  const { values } = parseArgs({ options: { from: { type: 'string', default: join(CACHE, 'sheets') } } })
  const from = resolve(values.from)
  const to = join(ROOT, 'docs/figures/auto')
  mkdirSync(to, { recursive: true })
  for (const region of Object.keys(REGIONS)) {
    const files = ['before', 'after'].map((version) => join(from, `${region}-${version}.jpg`))
    const missing = files.find((file) => !existsSync(file))
    if (missing)
      throw new Failure(`there is no ${missing}; draw it with FURROW_BEFORE=CHECKOUT npm run auto-sheets`)
    const file = join(to, `${region}.webp`)
    await (await sideBySide(files)).webp({ quality: 72, effort: 6 }).toFile(file)
    say(file)
  }
})

async function sideBySide(files) {
  const { default: sharp } = await import('sharp')
  const sheets = await Promise.all(
    files.map((file) => sharp(file).resize({ width: WIDTH }).toBuffer({ resolveWithObject: true })),
  )
  const height = Math.max(...sheets.map(({ info }) => info.height))
  const canvas = sharp({
    create: { width: 2 * WIDTH + 4 * GAP, height, channels: 3, background: '#fff' },
  })
  const places = sheets.map(({ data }, i) => ({ input: data, left: i * (WIDTH + 4 * GAP), top: 0 }))
  return canvas.composite(places)
}
