// `npm run ratios`: compares the frame time with wrinkles, relative to the plain face, with bench/ratios.json. `-- --write` updates the
// file. Growth only warns, because machines are noisy.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // Imports packages that `setUp` installs.
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
