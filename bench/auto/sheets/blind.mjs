// `npm run auto-sheets:blind`: copies contact sheets under neutral names in a random order.
// --from FOLDER: sheets. --out FOLDER: new folder for readers. --seed 1: random seed of the order.
// The file FOLDER.key.json, beside the folder for readers, tells which sheet is which.

import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { GAP } from '../../../scripts/figures/write.mjs'
import { Failure, main, say } from '../../../scripts/lib/run.mjs'
import { wholeNumber } from '../../../scripts/lib/whole-number.mjs'
import { CACHE } from '../sample-heads.mjs'
import { TILE } from './regions.mjs'

/** Rows of heads on a sheet for readers. More would be scaled down by most viewers. */
const ROWS = 4
const ROW = TILE + GAP

await main(async () => {
  const { values } = parseArgs({
    options: {
      from: { type: 'string', default: join(CACHE, 'sheets') },
      out: { type: 'string', default: 'blind' },
      seed: { type: 'string', default: '1' },
    },
  })
  const seed = wholeNumber('seed', values.seed, 0)
  const out = resolve(values.out)
  if (existsSync(out)) throw new Failure(`the folder exists, got ${out}; choose another with --out`)
  const parts = (await Promise.all(sheetsIn(resolve(values.from)).map(partsOf))).flat()
  const ranked = parts.map((part) => ({ ...part, rank: rankOf(seed, part) }))
  ranked.sort((a, b) => (a.rank < b.rank ? -1 : 1))
  mkdirSync(out, { recursive: true })
  const digits = String(ranked.length).length
  const key = {}
  for (const [i, { image, region, version, firstRow }] of ranked.entries()) {
    const name = `sheet-${String(i + 1).padStart(digits, '0')}`
    await image.png().toFile(join(out, `${name}.png`))
    key[name] = { region, version, firstRow }
  }
  const rows = Object.entries(key).map(([name, { region }]) => `${name},${region},,`)
  writeFileSync(join(out, 'scores.csv'), `sheet,region,score,remarks\n${rows.join('\n')}\n`)
  writeFileSync(`${out}.key.json`, `${JSON.stringify({ seed, sheets: key }, null, 2)}\n`)
  say(`${ranked.length} sheets in ${out}, key in ${out}.key.json`)
})

function sheetsIn(folder) {
  const names = existsSync(folder) ? readdirSync(folder).sort() : []
  const sheets = names.flatMap((name) => {
    const [, region, version] = name.match(/^(.+)-(before|after)\.jpg$/) ?? []
    return region ? [{ region, version, file: join(folder, name) }] : []
  })
  if (sheets.length === 0) throw new Failure(`no sheets in ${folder}; draw them with npm run auto-sheets`)
  return sheets
}

/** Cuts a sheet into parts of at most `ROWS` rows. */
async function partsOf({ region, version, file }) {
  const { default: sharp } = await import('sharp')
  const { width, height } = await sharp(file).metadata()
  const rows = Math.round((height + GAP) / ROW)
  return Array.from({ length: Math.ceil(rows / ROWS) }, (_, i) => {
    const top = i * ROWS * ROW
    const part = { left: 0, top, width, height: Math.min(ROWS * ROW - GAP, height - top) }
    return { region, version, firstRow: i * ROWS, image: sharp(file).extract(part) }
  })
}

/** Returns a text that sorts a part to a random place. */
function rankOf(seed, { region, version, firstRow }) {
  return createHash('sha256').update(`${seed} ${region} ${version} ${firstRow}`).digest('hex')
}
