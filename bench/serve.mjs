import { fileURLToPath } from 'node:url'
import { createServer } from 'vite'
import { SOURCES } from '../scripts/lib/sources.mjs'

export const ROOT = fileURLToPath(new URL('..', import.meta.url))

/**
 * Starts a Vite server for the repository. Browsers load pages from it, and this process loads modules with `ssrLoadModule`. Close it after use.
 *
 * @param plugins Vite plugins that serve other files.
 */
export async function serve(plugins = []) {
  const server = await createServer({
    root: ROOT,
    configFile: false,
    cacheDir: 'node_modules/.vite-bench',
    logLevel: 'warn',
    ...SOURCES,
    plugins,
    optimizeDeps: {
      entries: [
        'bench/page/page.html',
        'bench/files/page.html',
        'bench/cycles/page.html',
        'bench/cycles/babylon.html',
        'bench/babylon/page.html',
        'bench/godot/page.html',
      ],
      include: ['three', 'three/webgpu', 'three/tsl', 'three/addons/loaders/GLTFLoader.js'],
    },
    // Saving a file must not reload the page while frames are timed.
    server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
  })
  return server.listen()
}

/** Runs a benchmark, then closes the server. Prints the message of an error and sets exit code 1. */
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

/** Starts a browser with exact WebGPU timestamps. */
export async function launchTimed(server) {
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  // Without this flag, Chromium rounds WebGPU timestamps to 0.1 ms.
  return launchBrowser(['--enable-webgpu-developer-features'])
}

/** Opens a page of the server and waits until the page has defined the global variable named by `ready`. */
export async function openPage(server, browser, path, ready) {
  const { newPage } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const page = await newPage(browser)
  await page.goto(new URL(path, server.resolvedUrls.local[0]).href)
  await page.waitForFunction((name) => name in globalThis, ready)
  return page
}
