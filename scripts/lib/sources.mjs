import { fileURLToPath } from 'node:url'

const internal = (file) => fileURLToPath(new URL(`../../packages/furrow/internal/${file}`, import.meta.url))

// Entry points for the workspace only. The first match wins, so the longer one comes first.
const alias = { 'furrow/internal/three': internal('three.ts'), 'furrow/internal': internal('index.ts') }

const conditions = (platform) => ['furrow-source', 'module', platform, 'development|production']

/** Vite options that resolve the workspace's packages to sources instead of builds, in browsers and in Node. */
export const SOURCES = {
  resolve: { alias, conditions: conditions('browser') },
  ssr: { resolve: { conditions: conditions('node') } },
}
