/**
 * Starts the worker from its module in the source tree. In the published package, the plugin `workerAsText` in `vite.config.ts` replaces this
 * file. The bundled worker is then a string, and is started from a Blob URL. Only a Blob URL works with all bundlers and without a bundler
 * (see test/packages/worker.test.ts). Other methods have these problems:
 *
 * - `new Worker(new URL('./worker.js', import.meta.url))`: esbuild does not copy the file, and Vite before 8 lost it when pre-bundling.
 *   Browsers refuse workers from other origins, such as a CDN. Without a bundler, the browser requests forty modules.
 * - A second entry point that users turn into a worker (`?worker`, `worker-loader`): each bundler has a different syntax.
 * - The text of a function (`toString`): minifiers move parts of the function out of it.
 *
 * The string is imported dynamically, so bundlers put it into a separate chunk. A Content-Security-Policy must allow `worker-src blob:`, as
 * for `KTX2Loader` and `DRACOLoader` of three.js.
 */
export function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

/** Version of the worker's code. In the published package, it is a hash. Here, each page visit has a new version, because sources may change. */
export const version = `sources ${performance.timeOrigin}`
