// What pages download of the library, beside the figures in bench/sizes.json: `npm run size`, and `npm run size -- --write` to keep what
// is measured as the figures. Growth is a warning and no failure.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // It needs what `setUp` installs.
  const { compareDownload, warnings, writeFigures } = await import('./lib/download.mjs')
  const rows = await compareDownload()
  for (const { what, size, figure } of rows) {
    const [gzip, brotli] = [size.gzip, size.brotli].map((bytes) => String(bytes).padStart(6))
    say(`${gzip} bytes by gzip, ${brotli} by Brotli  ${what} (${figure ? `${figure.gzip} before` : 'new'})`)
  }
  for (const line of warnings(rows)) say(line)
  if (process.argv.includes('--write')) writeFigures(rows)
})
