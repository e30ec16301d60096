import { copyFileSync } from 'node:fs'
import { join } from 'node:path'
import { build } from 'vite'

/** Builds the studio of a checkout as it is published into a folder, and the page that times `furrow/auto` into `auto/` in it. */
export async function buildStudio(checkout, dist, files) {
  const options = { emptyOutDir: true, reportCompressedSize: false }
  await build({
    configFile: join(checkout, 'studio/vite.config.ts'),
    logLevel: 'silent',
    build: { ...options, outDir: dist },
  })
  await build({
    root: checkout,
    base: './',
    configFile: false,
    logLevel: 'silent',
    resolve: { conditions: ['furrow-source', 'module', 'browser', 'development|production'] },
    build: {
      ...options,
      outDir: join(dist, 'auto'),
      rolldownOptions: { input: join(checkout, 'bench/studio/auto.html') },
    },
  })
  for (const [name, path] of Object.entries({ ...files.avatars, low: files.low })) {
    copyFileSync(path, join(dist, 'auto', `${name}.glb`))
  }
}
