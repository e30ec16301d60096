import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { StudioPage } from '../studio-page.mjs'

const KILOBYTE = 1000

/** Measures the gzipped kB of all code that the studio loads at first, and of each code file. */
export async function measureSizes(bench, add) {
  const studio = await StudioPage.open(bench)
  const names = await studio.page.evaluate(() =>
    performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname.slice(1)),
  )
  await studio.close()
  const code = (name) => /\.(js|css|html|wasm)$/.test(name)
  const gzipped = (name) => gzipSync(readFileSync(join(bench.dist, name)), { level: 9 }).length / KILOBYTE
  const first = ['index.html', ...new Set(names.filter(code))]
  add(
    'first load, kB',
    first.reduce((sum, name) => sum + gzipped(name), 0),
  )
  for (const name of readdirSync(join(bench.dist, 'assets'))) {
    if (code(name)) add(`${name.replace(/-[\w-]{8}\./, '.')}, kB`, gzipped(join('assets', name)))
  }
}
