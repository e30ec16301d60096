import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { measureSizes } from '../../bench/size.mjs'
import { writeTable } from './marked-table.mjs'
import { ROOT } from './run.mjs'

const FIGURES = join(ROOT, 'bench/sizes.json')

/** Growth above which a warning is printed. */
const ALLOWED = 0.02

/** Bytes of each page and of what it fetches later, as they are now and as the repository's figures say. */
export async function compareDownload() {
  return compare(await measureSizes(), readFigures())
}

/** Each size beside its figure, and whether it has grown by more than is allowed. What has no figure is new, and has not grown. */
export function compare(sizes, figures) {
  return Object.entries(sizes).map(([what, size]) => {
    const figure = figures[what]
    return { what, size, figure, hasGrown: figure !== undefined && size.gzip > figure.gzip * (1 + ALLOWED) }
  })
}

/** Makes what is measured now the figures, and writes the table of docs/download.md. */
export function writeFigures(rows) {
  const figures = Object.fromEntries(rows.map(({ what, size }) => [what, size]))
  writeFileSync(FIGURES, `${JSON.stringify(figures, null, 2)}\n`)
  writeTable('docs/download.md', 'sizes', sizeTable(figures))
}

export const readFigures = () => JSON.parse(readFileSync(FIGURES, 'utf8'))

/** The lines of the table of sizes, in kB. */
export function sizeTable(figures) {
  const rows = Object.entries(figures).map(([what, { gzip, brotli }]) => {
    const cells = [gzip, brotli].map((bytes) => (bytes / 1000).toFixed(1))
    return `| ${what.replace(/furrow\/\w+/, '`$&`')} | ${cells.join(' | ')} |`
  })
  return ['| | gzip | Brotli |', '| --- | --- | --- |', ...rows]
}

/** One line about each that has grown. */
export function warnings(rows) {
  return rows
    .filter(({ hasGrown }) => hasGrown)
    .map(({ what, size, figure }) => {
      const percent = (100 * (size.gzip / figure.gzip - 1)).toFixed(1)
      return `download: ${what} has grown by ${percent}%, from ${figure.gzip} to ${size.gzip} bytes by gzip; if it must, run \`npm run size -- --write\``
    })
}
