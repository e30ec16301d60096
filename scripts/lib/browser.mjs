import { existsSync } from 'node:fs'
import { must, run, say } from './run.mjs'

/**
 * Finds a Chromium-based browser. If none is installed, installs Debian's as root, otherwise Playwright's. Call `setUp` first.
 *
 * @returns {Promise<string>} its path.
 */
export async function ensureBrowser() {
  const { findBrowser } = await import('../../packages/cli/dist/browser.js')
  try {
    return await findBrowser()
  } catch (error) {
    // The user has to fix an invalid FURROW_CHROMIUM.
    if (process.env.FURROW_CHROMIUM) throw error
  }
  if (process.getuid?.() === 0 && existsSync('/usr/bin/apt-get') && (await installByApt(findBrowser))) {
    return findBrowser()
  }
  say("installing Playwright's Chromium")
  await must(['npx', 'playwright', 'install', 'chromium'], { quiet: true })
  return findBrowser()
}

/** Installs Debian's browser. Returns false if that fails: some derivatives' `chromium` package is not the browser. */
async function installByApt(findBrowser) {
  say("installing Debian's chromium (apt-get)")
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' }
  const update = await run(['apt-get', 'update'], { quiet: true, env })
  const words = ['apt-get', 'install', '-y', '--no-install-recommends', 'chromium']
  if (update !== 0 || (await run(words, { quiet: true, env })) !== 0) return false
  try {
    return (await findBrowser()) !== ''
  } catch {
    return false
  }
}

/** Returns the names of the browser's GPUs by API, null for a missing API. */
export async function readAdapters() {
  const { launchBrowser, newPage } = await import('../../packages/cli/dist/browser.js')
  const { startLocalServer } = await import('../../packages/cli/dist/render/local-server.js')
  const server = await startLocalServer()
  const browser = await launchBrowser()
  try {
    const page = await newPage(browser)
    // WebGPU needs a secure origin; localhost is one.
    await page.goto(`${server.origin}/page/index.html`)
    return await page.evaluate(adaptersOfPage)
  } finally {
    await browser.close()
    await server.close()
  }
}

async function adaptersOfPage() {
  const gl = document.createElement('canvas').getContext('webgl2')
  const debug = gl?.getExtension('WEBGL_debug_renderer_info')
  const info = (await navigator.gpu?.requestAdapter())?.info
  return {
    'WebGL 2': gl ? String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER)) : null,
    WebGPU: info ? [info.vendor, info.architecture, info.description].filter(Boolean).join(' ') : null,
  }
}
