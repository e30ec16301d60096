import { join } from 'node:path'
import { runnerImport } from 'vite'
import { ROOT } from './run.mjs'
import { SOURCES } from './sources.mjs'

/**
 * Imports a TypeScript file of the repository. Packages of the workspace resolve to their sources, not to their builds.
 */
export async function importSource(path) {
  const { module } = await runnerImport(join(ROOT, path), {
    ...SOURCES,
    environments: { inline: { resolve: { ...SOURCES.ssr.resolve, noExternal: [/^furrow/] } } },
  })
  return module
}
