// Puts modules of the built package that most of its entries share into one file, which their own files then export from. Bundlers make a file
// of its own of each module that the page and what it fetches later share in different ways, and each of these compresses by itself.

import { rm } from 'node:fs/promises'
import { join } from 'node:path'
import { build } from 'vite'
import { ROOT } from './lib/run.mjs'

const PACKAGE = join(ROOT, 'packages/furrow')

/** Errors, and the checks that use them. */
const MODULES = ['error', 'argument', 'limits', 'name', 'image', 'check-areas']

const fileOf = (name, folder, extension) => join(PACKAGE, folder, 'core', `${name}.${extension}`)

await build({
  root: PACKAGE,
  configFile: false,
  logLevel: 'warn',
  build: {
    outDir: 'dist/core',
    emptyOutDir: false,
    sourcemap: true,
    minify: false,
    target: 'es2022',
    lib: {
      entry: Object.fromEntries(MODULES.map((name) => [name, fileOf(name, 'src', 'ts')])),
      formats: ['es'],
    },
    rolldownOptions: {
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: '[name].js',
        codeSplitting: { groups: [{ name: 'checks' }] },
        // Readable, and the same in every build.
        minifyInternalExports: false,
        // They are in the package.
        sourcemapExcludeSources: true,
      },
    },
  },
})
// Those of the replaced files.
await Promise.all(MODULES.map((name) => rm(`${fileOf(name, 'dist', 'js')}.map`, { force: true })))
