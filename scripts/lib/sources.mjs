import { fileURLToPath } from 'node:url'

const internal = (file) => fileURLToPath(new URL(`../../packages/furrow/internal/${file}`, import.meta.url))

// Entry points that exist only in the workspace. Vite uses the first match, so the longer name comes first.
const alias = { 'furrow/internal/three': internal('three.ts'), 'furrow/internal': internal('index.ts') }

const conditions = (platform) => ['furrow-source', 'module', platform, 'development|production']

/** Vite options that resolve packages of the workspace to their sources, not to their builds. For browsers and Node. */
export const SOURCES = {
  resolve: { alias, conditions: conditions('browser') },
  ssr: { resolve: { conditions: conditions('node') } },
}
