/**
 * Starts the worker of `autoWrinklesInWorker` from its module, as it is in the sources. The package has another file in its place, which
 * `scripts/bundle-worker.mjs` writes: the worker with all that it imports as one string, started from a Blob URL. No other form needs
 * nothing of users (tried with Vite 8, webpack 5, esbuild 0.28 and a plain page, see test/packages/worker.test.ts):
 *
 * - `new Worker(new URL('./worker.js', import.meta.url))` is for applications. esbuild leaves it as it is and copies no file; Vite before
 *   8 pre-bundled dependencies and lost the file; browsers refuse a worker from another origin, such as a CDN in an import map; and the
 *   unbundled modules take forty requests.
 * - A second entry that users turn into a worker themselves (`?worker`, `worker-loader`) is written differently for each bundler.
 * - The text of a function (`toString`) does not survive minifiers and helpers.
 *
 * The string costs a page nothing until it is used: it is imported dynamically, and bundlers put it into a file of its own. It needs
 * `worker-src blob:` where a page has a Content-Security-Policy, which three.js's KTX2Loader and DRACOLoader need too.
 */
export function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

/** Of the code in the worker: the package has a hash of it. The sources change without one, so that each visit of a page has its own. */
export const version = `sources ${performance.timeOrigin}`
