import { fileURLToPath } from 'node:url'
import { createServer } from 'vite'
import { SOURCES } from '../scripts/lib/sources.mjs'

export const ROOT = fileURLToPath(new URL('..', import.meta.url))

/** Serves the repository to browsers, and to this process by `ssrLoadModule`. The caller closes the server. */
export async function serve() {
  const server = await createServer({
    root: ROOT,
    configFile: false,
    cacheDir: 'node_modules/.vite-bench',
    logLevel: 'warn',
    ...SOURCES,
    optimizeDeps: {
      entries: [
        'bench/page/page.html',
        'bench/files/page.html',
        'bench/cycles/page.html',
        'bench/cycles/babylon.html',
        'bench/babylon/page.html',
      ],
      include: ['three', 'three/webgpu', 'three/tsl', 'three/addons/loaders/GLTFLoader.js'],
    },
    // Saving a file must not reload the page while frames are timed.
    server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
  })
  return server.listen()
}

/** Runs a benchmark and closes its server. Prints an error as one line. */
export async function runServed(server, run) {
  try {
    await run()
  } catch (error) {
    process.stderr.write(`${error.message}\n`)
    process.exitCode = 1
  } finally {
    await server.close()
  }
}

/** Starts a browser for timing frames. */
export async function launchTimed(server) {
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  // By default WebGPU timestamps are quantised to 0.1 ms.
  return launchBrowser(['--enable-webgpu-developer-features'])
}

/** Opens a page and waits until it defines the global named `ready`. */
export async function openPage(server, browser, path, ready) {
  const { newPage } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const page = await newPage(browser)
  await page.goto(new URL(path, server.resolvedUrls.local[0]).href)
  await page.waitForFunction((name) => name in globalThis, ready)
  return page
}
