// `npm run ratios`: measures the ratio of frame times with and without wrinkles, and compares it with
// bench/ratios.json. `-- --write` updates the file. Growth causes only a warning, because timings on a machine vary.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // Imported late, because the module needs packages that `setUp` installs.
  const { measureTwice, readFigures, warnings, writeFigures } = await import('../bench/ratios.mjs')
  const figures = readFigures()
  const ratios = await measureTwice(figures)
  for (const [name, ratio] of Object.entries(ratios))
    say(
      `${name.padEnd(24)} ${ratio.toFixed(2)} (${figures[name] ? `${figures[name].toFixed(2)} before` : 'new'})`,
    )
  for (const line of warnings(ratios, figures)) say(line)
  if (process.argv.includes('--write')) writeFigures(ratios)
})
