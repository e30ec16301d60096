import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { mtoonNodes } from '../../../../scripts/lib/mtoon-nodes.mjs'
import { SOURCES } from '../../../../scripts/lib/sources.mjs'

/** Bundles the page into dist/page, so that the installed command needs no bundler. */
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
    // One chunk contains both three.js renderers. Its size does not matter, because the browser gets it from disk.
    chunkSizeWarningLimit: 4000,
    // Silences a warning: the library loads some modules on demand that this page already contains.
    rolldownOptions: { checks: { ineffectiveDynamicImport: false } },
  },
})
