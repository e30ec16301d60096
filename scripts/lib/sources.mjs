import { fileURLToPath } from 'node:url'

// Only the workspace has this entry: see the file.
const alias = {
  'furrow/internal': fileURLToPath(new URL('../../packages/furrow/internal.ts', import.meta.url)),
}

const conditions = (platform) => ['furrow-source', 'module', platform, 'development|production']

/** Options of Vite that resolve the workspace's packages to their sources instead of their builds, in browsers and in Node. */
export const SOURCES = {
  resolve: { alias, conditions: conditions('browser') },
  ssr: { resolve: { conditions: conditions('node') } },
}
