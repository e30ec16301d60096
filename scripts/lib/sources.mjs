import { fileURLToPath } from 'node:url'

const internal = (file) => fileURLToPath(new URL(`../../packages/furrow/internal/${file}`, import.meta.url))

// Only the workspace has these entries: see their files. The first that fits is taken.
const alias = { 'furrow/internal/three': internal('three.ts'), 'furrow/internal': internal('index.ts') }

const conditions = (platform) => ['furrow-source', 'module', platform, 'development|production']

/** Options of Vite that resolve the workspace's packages to their sources instead of their builds, in browsers and in Node. */
export const SOURCES = {
  resolve: { alias, conditions: conditions('browser') },
  ssr: { resolve: { conditions: conditions('node') } },
}
