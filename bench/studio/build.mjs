import { copyFileSync, existsSync, mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { build } from 'vite'
import { SOURCES } from '../../scripts/lib/sources.mjs'

/** Builds the studio of a checkout into the folder `dist`. Builds the page that times `furrow/auto` into the subfolder `auto` of `dist`. */
export async function buildStudio(checkout, dist, files) {
  await build({
    configFile: join(checkout, 'studio/vite.config.ts'),
    logLevel: 'silent',
    build: { outDir: dist, emptyOutDir: true, reportCompressedSize: false },
  })
  mkdirSync(join(dist, 'auto'), { recursive: true })
  const page = join(checkout, 'bench/studio/auto.html')
  if (existsSync(page)) await buildPage(checkout, page, join(dist, 'auto'))
  for (const [name, path] of Object.entries({ ...files.avatars, low: files.low })) {
    copyFileSync(path, join(dist, 'auto', `${name}.glb`))
  }
}

async function buildPage(root, page, outDir) {
  await build({
    root,
    base: './',
    configFile: false,
    logLevel: 'silent',
    resolve: SOURCES.resolve,
    build: { outDir, emptyOutDir: true, reportCompressedSize: false, rolldownOptions: { input: page } },
  })
}
