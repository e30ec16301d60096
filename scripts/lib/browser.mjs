import { existsSync } from 'node:fs'
import { must, run, say } from './run.mjs'

/**
 * Finds a Chromium-based browser. If there is none, installs one: Debian's package if the user is root, otherwise the
 * browser of Playwright. Call `setUp` first.
 *
 * @returns {Promise<string>} path of the browser.
 */
export async function ensureBrowser() {
  const { findBrowser } = await import('../../packages/cli/dist/browser.js')
  try {
    return await findBrowser()
  } catch (error) {
    // FURROW_CHROMIUM is invalid. The user has to correct it.
    if (process.env.FURROW_CHROMIUM) throw error
  }
  if (process.getuid?.() === 0 && existsSync('/usr/bin/apt-get') && (await installByApt(findBrowser))) {
    return findBrowser()
  }
  say("installing Playwright's Chromium")
  await must(['npx', 'playwright', 'install', 'chromium'], { quiet: true })
  return findBrowser()
}

/**
 * Installs the browser of Debian. Returns false if that fails. On some systems derived from Debian, the package
 * `chromium` does not contain the browser.
 */
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

/**
 * Returns the name of the GPU that the browser uses for WebGL 2 and for WebGPU. The name is null if the browser lacks
 * the API.
 */
export async function readAdapters() {
  const { launchBrowser, newPage } = await import('../../packages/cli/dist/browser.js')
  const { startLocalServer } = await import('../../packages/cli/dist/render/local-server.js')
  const server = await startLocalServer()
  const browser = await launchBrowser()
  try {
    const page = await newPage(browser)
    // Pages have WebGPU only on a secure origin, such as localhost.
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
