// `npm run sheets:publish -- --from FOLDER --to docs/figures/auto`: writes both versions of each sheet side by side, the first version on the
// left.

import { mkdirSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { Failure, main, say } from '../../../scripts/lib/run.mjs'
import { readSheets } from './read-sheets.mjs'

/** Width of one sheet, pixels. */
const WIDTH = 1000

await main(async () => {
  const { values } = parseArgs({ options: { from: { type: 'string' }, to: { type: 'string' } } })
  if (!values.from || !values.to)
    throw new Failure('usage: npm run sheets:publish -- --from FOLDER --to FOLDER')
  const { parts, versions, gap } = readSheets(resolve(values.from))
  const to = resolve(values.to)
  mkdirSync(to, { recursive: true })
  for (const [sheet, files] of new Map(parts.map((part) => [part.sheet, part.files]))) {
    const missing = Object.keys(versions).find((version) => !files[version])
    if (missing) throw new Failure(`the sheet ${sheet}-${missing}.jpg is missing; draw all versions`)
    const file = join(to, `${sheet}.webp`)
    const ordered = Object.keys(versions).map((version) => files[version])
    await (await sideBySide(ordered, 4 * gap)).webp({ quality: 72, effort: 6 }).toFile(file)
    say(file)
  }
})

async function sideBySide(files, gap) {
  const { default: sharp } = await import('sharp')
  const sheets = await Promise.all(
    files.map((file) => sharp(file).resize({ width: WIDTH }).toBuffer({ resolveWithObject: true })),
  )
  const height = Math.max(...sheets.map(({ info }) => info.height))
  const canvas = sharp({
    create: { width: 2 * WIDTH + gap, height, channels: 3, background: '#fff' },
  })
  const places = sheets.map(({ data }, i) => ({ input: data, left: i * (WIDTH + gap), top: 0 }))
  return canvas.composite(places)
}
