// What pages download of the library, beside the figures in bench/sizes.json: `npm run size`, and `npm run size -- --write` to keep what
// is measured as the figures. Growth is a warning and no failure.

import { compareDownload, warnings, writeFigures } from './lib/download.mjs'
import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  const rows = await compareDownload()
  for (const { what, size, figure } of rows) {
    const before = figure ? `${figure.gzip} before` : 'new'
    say(
      `${String(size.gzip).padStart(6)} bytes by gzip, ${String(size.brotli).padStart(6)} by Brotli  ${what} (${before})`,
    )
  }
  for (const line of warnings(rows)) say(line)
  if (process.argv.includes('--write')) writeFigures(rows)
})
