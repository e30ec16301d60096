// `npm run sheets:blind -- --from FOLDER`: copies parts of contact sheets under neutral names in a random order.
// --from FOLDER: sheets. --out FOLDER: new folder for readers. --seed 1: random seed of the order.
// The file FOLDER.key.json, beside the folder for readers, tells which part is which.

import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { parseArgs } from 'node:util'
import { Failure, main, say } from '../../../scripts/lib/run.mjs'
import { wholeNumber } from '../../../scripts/lib/whole-number.mjs'
import { readSheets } from './read-sheets.mjs'

await main(async () => {
  const { values } = parseArgs({
    options: {
      from: { type: 'string' },
      out: { type: 'string', default: 'blind' },
      seed: { type: 'string', default: '1' },
    },
  })
  if (!values.from) throw new Failure('usage: npm run sheets:blind -- --from FOLDER [--out blind] [--seed 1]')
  const seed = wholeNumber('seed', values.seed, 0)
  const out = resolve(values.out)
  if (existsSync(out)) throw new Failure(`the folder exists, got ${out}; choose another with --out`)
  const { parts, versions, ...sizes } = readSheets(resolve(values.from))
  const ranked = parts.flatMap(({ files, ...part }) =>
    Object.entries(files).map(([version, file]) => ({
      ...part,
      version,
      file,
      rank: rankOf(seed, part, version),
    })),
  )
  ranked.sort((a, b) => (a.rank < b.rank ? -1 : 1))
  mkdirSync(out, { recursive: true })
  const digits = String(ranked.length).length
  const key = {}
  for (const [i, part] of ranked.entries()) {
    const name = `sheet-${String(i + 1).padStart(digits, '0')}`
    await (await imageOf(part, sizes)).png().toFile(join(out, `${name}.png`))
    key[name] = { region: part.region, version: part.version, firstRow: part.firstRow }
  }
  const rows = Object.entries(key).map(([name, { region }]) => `${name},${region},,`)
  writeFileSync(join(out, 'scores.csv'), `sheet,region,score,remarks\n${rows.join('\n')}\n`)
  const regions = [...new Set(parts.map(({ region }) => region))]
  writeFileSync(`${out}.key.json`, `${JSON.stringify({ seed, versions, regions, sheets: key }, null, 2)}\n`)
  say(`${ranked.length} sheets in ${out}, key in ${out}.key.json`)
})

async function imageOf({ file, firstRow, rows }, { rowHeight, gap }) {
  const { default: sharp } = await import('sharp')
  const { width, height } = await sharp(file).metadata()
  const top = firstRow * rowHeight
  return sharp(file).extract({ left: 0, top, width, height: Math.min(rows * rowHeight - gap, height - top) })
}

/** Returns a text that sorts a part to a random place. */
function rankOf(seed, { region, firstRow }, version) {
  return createHash('sha256').update(`${seed} ${region} ${version} ${firstRow}`).digest('hex')
}
