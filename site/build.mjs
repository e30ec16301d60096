// `npm run site`: builds the site into site/dist. See site/README.md.

import { rmSync } from 'node:fs'
import { join } from 'node:path'
import { build as buildWithVite } from 'vite'
import { build as buildPages } from 'vitepress'
import { main, must, ROOT, say } from '../scripts/lib/run.mjs'
import { setUp } from '../scripts/lib/set-up.mjs'

const SITE = join(ROOT, 'site')
const PAGES = join(SITE, 'pages')
const DIST = join(SITE, 'dist')

await main(async () => {
  await setUp()
  await inOrder([
    ['reference', () => must(['npm', 'run', 'api', '--silent'])],
    ['pages', gather],
    ['site', () => buildPages(SITE)],
    ['examples', buildExamples],
    ['studio', buildStudio],
  ])
  say('site/dist is ready: serve it with any static file server, under any path')
})

async function gather() {
  rmSync(PAGES, { recursive: true, force: true })
  // Imported late, because these modules need packages that `setUp` builds.
  const { gatherPages } = await import('./gather/pages.mjs')
  const { gatherCommands } = await import('./gather/commands.mjs')
  const { gatherExamples } = await import('./gather/examples.mjs')
  const { gatherFirstPage } = await import('./gather/first-page.mjs')
  gatherPages(PAGES)
  gatherExamples(PAGES)
  await gatherCommands(PAGES)
  await gatherFirstPage(PAGES)
}

async function buildExamples() {
  const { buildLiveExamples } = await import('./gather/live-examples.mjs')
  await buildLiveExamples(join(DIST, 'examples/live'))
}

function buildStudio() {
  const configFile = join(ROOT, 'studio/vite.config.ts')
  return buildWithVite({
    configFile,
    logLevel: 'error',
    build: { outDir: join(DIST, 'studio'), emptyOutDir: true },
  })
}

async function inOrder(steps) {
  for (const [name, work] of steps) {
    const start = performance.now()
    await work()
    say(`${name.padEnd(10)} ${((performance.now() - start) / 1000).toFixed(1).padStart(5)} s`)
  }
}
