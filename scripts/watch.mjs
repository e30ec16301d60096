// Runs the tests of a project again as files change: `npm run watch` (unit), `npm run watch:gpu`. What follows `--` goes to
// Vitest, e.g. `npm run watch:gpu -- tension`.

import { ensureBrowser } from './lib/browser.mjs'
import { main, must } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  const [project, ...options] = process.argv.slice(2)
  if (project !== 'unit') process.env.FURROW_CHROMIUM = await ensureBrowser()
  await must(['npx', 'vitest', 'watch', '--project', project, ...options], { input: 'inherit' })
})
