// `npm run browsers`: measures what Chromium, Firefox ESR and WebKitGTK support, and updates the table of browsers in
// README.md.

import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { ensureBrowser } from './lib/browser.mjs'
import { browserTable, readReport, writeBrowsers } from './lib/browser-table.mjs'
import { missingPackages } from './lib/other-browsers.mjs'
import { Failure, main, run, say } from './lib/run.mjs'
import { setUp } from './lib/set-up.mjs'
import { VITEST } from './lib/test-files.mjs'

await main(async () => {
  const missing = [...new Set(['firefox', 'webkit'].flatMap(missingPackages))]
  if (missing.length > 0)
    throw new Failure(
      `browsers: missing packages, got none of ${missing.join(', ')}; run apt-get install ${missing.join(' ')}`,
    )
  await setUp()
  const folder = await mkdtemp(join(tmpdir(), 'furrow-browsers-'))
  try {
    const file = join(folder, 'report.json')
    const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`]
    const env = { ...process.env, FURROW_CHROMIUM: await ensureBrowser(), FURROW_BROWSERS: 'all' }
    await run([...VITEST, 'run', '--project', 'browsers', 'test/browsers/capabilities', ...reporters], {
      env,
    })
    const measured = readReport(JSON.parse(await readFile(file, 'utf8')))
    writeBrowsers(measured)
    say(browserTable(measured).join('\n'))
  } finally {
    await rm(folder, { recursive: true })
  }
})
