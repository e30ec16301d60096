import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { mtoonNodes } from '../../../../scripts/lib/mtoon-nodes.mjs'
import { SOURCES } from '../../../../scripts/lib/sources.mjs'

/** Bundles the page into dist/, so that the installed command needs no bundler. */
export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  logLevel: 'warn',
  resolve: SOURCES.resolve,
  plugins: [mtoonNodes()],
  build: {
    outDir: '../../dist/page',
    emptyOutDir: true,
    target: 'esnext',
    license: { fileName: 'LICENSES.md' },
    // Both three.js renderers are in one chunk. It is read from disk, so its size does not matter.
    chunkSizeWarningLimit: 4000,
    // The library imports chunks on demand that this page already contains.
    rolldownOptions: { checks: { ineffectiveDynamicImport: false } },
  },
})
