// `npm run watch` and `npm run watch:gpu`: run the unit or GPU tests again whenever a file changes. Arguments after
// `--` go to Vitest, e.g. `-- tension`.

import { ensureBrowser } from './lib/browser.mjs'
import { main, must } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'

await main(async () => {
  await setUp()
  const [project, ...options] = process.argv.slice(2)
  if (project !== 'unit') process.env.FURROW_CHROMIUM = await ensureBrowser()
  await must(['npx', 'vitest', 'watch', '--project', project, ...options], { input: 'inherit' })
})
