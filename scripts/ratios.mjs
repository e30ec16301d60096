// What a frame with wrinkles costs compared with the plain face, beside the figures in bench/ratios.json: `npm run ratios`, and
// `npm run ratios -- --write` to keep what is measured as the figures. Growth is a warning and no failure: machines are noisy.

import { main, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  // These need what it installs.
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
