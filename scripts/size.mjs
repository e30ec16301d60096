// What pages download of the library, beside the figures in bench/sizes.json: `npm run size`, and `npm run size -- --write` to keep what
// is measured as the figures. Growth is a warning and no failure. `--floor` measures the least that shows the shipped face too,
// `--peers` other libraries.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // These need what it installs.
  const { compareDownload, warnings, writeFigures } = await import('./lib/download.mjs')
  const { measureFloor, measurePeers } = await import('../bench/size.mjs')
  const rows = await compareDownload()
  for (const { what, size, figure } of rows)
    print(size, `${what} (${figure ? `${figure.gzip} before` : 'new'})`)
  for (const line of warnings(rows)) say(line)
  if (process.argv.includes('--write')) writeFigures(rows)
  const more = {
    ...(process.argv.includes('--floor') && (await measureFloor())),
    ...(process.argv.includes('--peers') && (await measurePeers())),
  }
  for (const [what, size] of Object.entries(more)) print(size, what)
})

function print({ gzip, brotli }, what) {
  say(`${String(gzip).padStart(6)} bytes by gzip, ${String(brotli).padStart(6)} by Brotli  ${what}`)
}
