import { join } from 'node:path'
import { build } from 'vite'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/**
 * Bundles a TypeScript file for Node. Packages of the workspace are bundled from their sources.
 *
 * @param {string} entry path of the file, relative to the root of the repository.
 * @returns {Promise<string>} path of the bundle.
 */
export async function bundle(entry) {
  const name = entry.replaceAll(/\W+/g, '-')
  const outDir = join(ROOT, 'node_modules/.cache/furrow', name)
  await build({
    configFile: false,
    root: ROOT,
    logLevel: 'error',
    ...SOURCES,
    build: {
      ssr: join(ROOT, entry),
      outDir,
      emptyOutDir: true,
      rolldownOptions: { output: { entryFileNames: 'index.mjs' } },
    },
  })
  return join(outDir, 'index.mjs')
}
