import { ROOT } from './run.mjs'

/** Time in which a face reaches its pose after the first frame, milliseconds. */
const SETTLE_TIME = 3000

/**
 * Takes pictures of the canvases of example pages. Consecutive pictures of one page share it.
 *
 * @param {{ page: string, width: number, height: number, sliders?: Record<string, number> }[]} pages file names with queries, window
 *   sizes in pixels, and values of sliders by their labels.
 * @returns {Promise<{ width: number, height: number, pixels: Uint8Array }[]>} pictures as RGBA bytes.
 */
export async function shootPages(pages) {
  if (pages.length === 0) return []
  const { default: sharp } = await import('sharp')
  const { preview } = await import('vite')
  const { launchBrowser, newPage } = await import('../../packages/cli/dist/browser.js')
  const options = { configFile: false, logLevel: 'silent', root: ROOT, build: { outDir: '.' } }
  const server = await preview({ ...options, preview: { host: '127.0.0.1', port: 0 } })
  const browser = await launchBrowser()
  const pictures = []
  try {
    let page
    for (const [i, { page: name, width, height, sliders = {} }] of pages.entries()) {
      if (pages[i - 1]?.page !== name) {
        await page?.close()
        page = await newPage(browser, { viewport: { width, height } })
        await page.goto(new URL(`/examples/${name}`, server.resolvedUrls.local[0]).href)
        await page.waitForSelector('canvas')
        await nextFrame(page)
        await page.waitForTimeout(SETTLE_TIME)
      }
      for (const [label, value] of Object.entries(sliders)) await page.getByLabel(label).fill(`${value}`)
      await nextFrame(page)
      const picture = sharp(await page.locator('canvas').screenshot())
        .ensureAlpha()
        .raw()
      const { data, info } = await picture.toBuffer({ resolveWithObject: true })
      pictures.push({ width: info.width, height: info.height, pixels: data })
    }
  } finally {
    await browser.close()
    await server.close()
  }
  return pictures
}

/** Waits until the page has drawn another frame. */
function nextFrame(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))))
}
