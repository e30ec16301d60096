// `npm run size`: compares the download size of the library with bench/sizes.json. `-- --write` updates the file.
// Growth causes only a warning.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // Imported late, because the module needs packages that `setUp` installs.
  const { compareDownload, warnings, writeFigures } = await import('./lib/download.mjs')
  const rows = await compareDownload()
  for (const { name, size, figure } of rows) {
    const [gzip, brotli] = [size.gzip, size.brotli].map((bytes) => String(bytes).padStart(6))
    say(`${gzip} bytes by gzip, ${brotli} by Brotli  ${name} (${figure ? `${figure.gzip} before` : 'new'})`)
  }
  for (const line of warnings(rows)) say(line)
  if (process.argv.includes('--write')) writeFigures(rows)
})
