/**
 * Starts the worker of `autoWrinklesInWorker` from its module in the sources. In the package, `scripts/bundle-worker.mjs` replaces this
 * file: the bundled worker is a string, started from a Blob URL. No other form works with all bundlers and without one (see
 * test/packages/worker.test.ts):
 *
 * - `new Worker(new URL('./worker.js', import.meta.url))` is for applications. esbuild copies no file, and Vite before 8 lost it when
 *   pre-bundling. Browsers refuse workers from other origins, such as a CDN. The unbundled modules take forty requests.
 * - A second entry that users turn into a worker (`?worker`, `worker-loader`) is written differently for each bundler.
 * - The text of a function (`toString`) does not survive minifiers and helpers.
 *
 * The string is imported dynamically, so bundlers put it into a separate chunk. A Content-Security-Policy must allow `worker-src blob:`, as
 * for KTX2Loader and DRACOLoader of three.js.
 */
export function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

/** Version of the worker's code: a hash in the package. Sources have no hash, so that each page visit has a new version. */
export const version = `sources ${performance.timeOrigin}`
