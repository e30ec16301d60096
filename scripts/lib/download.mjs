import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { measureSizes } from '../../bench/size.mjs'
import { writeTable } from './marked-table.mjs'
import { ROOT } from './run.mjs'

const FIGURES = join(ROOT, 'bench/sizes.json')

/** Largest relative growth without a warning. */
const ALLOWED = 0.02

/**
 * Measures the download of each page and of the chunks that it loads on demand. Compares the sizes with
 * bench/sizes.json.
 */
export async function compareDownload() {
  return compare(await measureSizes(), readFigures())
}

/** Pairs each measured size with the stored size. A size that is not stored counts as not grown. */
export function compare(sizes, figures) {
  return Object.entries(sizes).map(([name, size]) => {
    const figure = figures[name]
    return { name, size, figure, hasGrown: figure !== undefined && size.gzip > figure.gzip * (1 + ALLOWED) }
  })
}

/** Stores the measured sizes in bench/sizes.json, and updates the table of docs/download.md. */
export function writeFigures(rows) {
  const figures = Object.fromEntries(rows.map(({ name, size }) => [name, size]))
  writeFileSync(FIGURES, `${JSON.stringify(figures, null, 2)}\n`)
  writeTable('docs/download.md', 'sizes', sizeTable(figures))
}

export const readFigures = () => JSON.parse(readFileSync(FIGURES, 'utf8'))

export function sizeTable(figures) {
  const rows = Object.entries(figures).map(([name, { gzip, brotli }]) => {
    const cells = [gzip, brotli].map((bytes) => (bytes / 1000).toFixed(1))
    return `| ${name.replace(/furrow\/\w+/, '`$&`')} | ${cells.join(' | ')} |`
  })
  return ['| | gzip | Brotli |', '| --- | --- | --- |', ...rows]
}

export function warnings(rows) {
  return rows
    .filter(({ hasGrown }) => hasGrown)
    .map(({ name, size, figure }) => {
      const percent = (100 * (size.gzip / figure.gzip - 1)).toFixed(1)
      return `download: ${name} has grown by ${percent}%, from ${figure.gzip} to ${size.gzip} bytes by gzip; if intended, run \`npm run size -- --write\``
    })
}
