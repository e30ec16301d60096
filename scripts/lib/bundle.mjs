import { join } from 'node:path'
import { build } from 'vite'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/**
 * Bundles a TypeScript file with the sources of the workspace's packages, for Node.
 *
 * @param {string} entry path relative to the repository's root.
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
