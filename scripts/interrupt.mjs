// `npm run interrupt -- --moments 20 --command render`: starts a command that writes files, and interrupts it at 20
// different moments. Default: all such commands.

import { parseArgs } from 'node:util'
import { ensureBrowser } from './lib/browser.mjs'
import { main, must } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'
import { wholeNumber } from './lib/whole-number.mjs'

await main(async () => {
  const { values } = parseArgs({
    options: { command: { type: 'string' }, moments: { type: 'string', default: '20' } },
  })
  const moments = wholeNumber('moments', values.moments, 1)
  await setUp()
  const env = {
    ...process.env,
    FURROW_CHROMIUM: await ensureBrowser(),
    FURROW_MOMENTS: String(moments),
    ...(values.command && { FURROW_COMMAND: values.command }),
  }
  await must(['npx', 'vitest', 'run', '--project', 'pages', 'interruption', '--reporter=verbose'], { env })
})
