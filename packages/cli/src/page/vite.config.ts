import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { mtoonNodes } from '../../../../scripts/lib/mtoon-nodes.mjs'
import { SOURCES } from '../../../../scripts/lib/sources.mjs'

/** Bundles the page that draws into dist/, so that the installed command needs no bundler. */
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
    // Both renderers of three.js in one file, read from disk: its size costs nothing.
    chunkSizeWarningLimit: 4000,
    // The library fetches on demand what this page has anyway.
    rolldownOptions: { checks: { ineffectiveDynamicImport: false } },
  },
})
