import { existsSync } from 'node:fs'
import { must, run, say } from './run.mjs'

/**
 * Path of a Chromium-based browser. Where none is installed, one is: Debian's by its package manager when we may,
 * otherwise Playwright's. Call it after `setUp`.
 */
export async function ensureBrowser() {
  const { findBrowser } = await import('../../packages/cli/dist/browser.js')
  try {
    return await findBrowser()
  } catch (error) {
    // A variable that points nowhere is for its owner to mend.
    if (process.env.FURROW_CHROMIUM) throw error
  }
  if (process.getuid?.() === 0 && existsSync('/usr/bin/apt-get') && (await installByApt(findBrowser))) {
    return findBrowser()
  }
  say("installing Playwright's Chromium")
  await must(['npx', 'playwright', 'install', 'chromium'], { quiet: true })
  return findBrowser()
}

/** Whether it could be installed: some relatives of Debian have a `chromium` that is not the browser. */
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

/** What the browser draws with, by API. Throws where WebGL 2 or WebGPU is missing: nothing is left out in silence. */
export async function readAdapters() {
  const { launchBrowser, newPage } = await import('../../packages/cli/dist/browser.js')
  const { startLocalServer } = await import('../../packages/cli/dist/render/local-server.js')
  const server = await startLocalServer()
  const browser = await launchBrowser()
  try {
    const page = await newPage(browser)
    // WebGPU is there for secure addresses alone, of which this computer's own are.
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
