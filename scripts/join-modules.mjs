// Puts modules of the built package that most of its entries share into one file, which their own files then export from. Rolldown moves a
// module that a page shares with what it fetches later into the page's file, unless another such module imports it, which it shares with
// something else and has not moved yet. Errors and checks would so come in files of their own, which compress by themselves. With these
// modules in one, all that a page of `furrow/three` or `furrow/webgpu` shares is in its own file: `npm run size` says when that ends.

import { rm } from 'node:fs/promises'
import { join } from 'node:path'
import { build } from 'vite'
import { ROOT } from './lib/run.mjs'

const PACKAGE = join(ROOT, 'packages/furrow')

/** Errors, checks, and what else stands in the way. They import each other only: Babylon.js has them without three.js. */
const MODULES = [
  'core/error',
  'core/argument',
  'core/limits',
  'core/name',
  'core/image',
  'core/check-areas',
  'runtime/atlas-cells',
  'three/three-version',
]

const fileOf = (name, folder, extension) => join(PACKAGE, folder, `${name}.${extension}`)

await build({
  root: PACKAGE,
  configFile: false,
  logLevel: 'warn',
  build: {
    outDir: 'dist',
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
        chunkFileNames: 'core/[name].js',
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
