import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { measureSizes } from '../../bench/size.mjs'
import { writeTable } from './marked-table.mjs'
import { ROOT } from './run.mjs'

const FIGURES = join(ROOT, 'bench/sizes.json')

/** Relative growth without a warning. */
const ALLOWED = 0.02

/** Measures the bytes of each page and its lazy chunks, and compares them with the repository's figures. */
export async function compareDownload() {
  return compare(await measureSizes(), readFigures())
}

/** Pairs each size with its figure. A size without a figure has not grown. */
export function compare(sizes, figures) {
  return Object.entries(sizes).map(([name, size]) => {
    const figure = figures[name]
    return { name, size, figure, hasGrown: figure !== undefined && size.gzip > figure.gzip * (1 + ALLOWED) }
  })
}

/** Stores the sizes as figures, and updates the table of docs/download.md. */
export function writeFigures(rows) {
  const figures = Object.fromEntries(rows.map(({ name, size }) => [name, size]))
  writeFileSync(FIGURES, `${JSON.stringify(figures, null, 2)}\n`)
  writeTable('docs/download.md', 'sizes', sizeTable(figures))
}

export const readFigures = () => JSON.parse(readFileSync(FIGURES, 'utf8'))

/** Formats the table of sizes, in kB. */
export function sizeTable(figures) {
  const rows = Object.entries(figures).map(([name, { gzip, brotli }]) => {
    const cells = [gzip, brotli].map((bytes) => (bytes / 1000).toFixed(1))
    return `| ${name.replace(/furrow\/\w+/, '`$&`')} | ${cells.join(' | ')} |`
  })
  return ['| | gzip | Brotli |', '| --- | --- | --- |', ...rows]
}

/** Returns one warning per size that has grown. */
export function warnings(rows) {
  return rows
    .filter(({ hasGrown }) => hasGrown)
    .map(({ name, size, figure }) => {
      const percent = (100 * (size.gzip / figure.gzip - 1)).toFixed(1)
      return `download: ${name} has grown by ${percent}%, from ${figure.gzip} to ${size.gzip} bytes by gzip; if intended, run \`npm run size -- --write\``
    })
}
