// `node site/poster.mjs`: renders the posters of the first page from the built site. A poster is shown until the face
// is loaded. Run this script after a change of the face or its lighting.

import { join } from 'node:path'
import sharp from 'sharp'
import { main, ROOT } from '../scripts/lib/run.mjs'
import { serveSite } from './serve.mjs'

const POSTERS = [
  ['poster.webp', 1120],
  ['poster-small.webp', 560],
]

/** Style sheet that hides everything but the face, and makes the background transparent. */
const FACE_ONLY = `
  * { background: none !important; }
  body * { visibility: hidden !important; }
  .stage .face { position: fixed !important; inset: 0; width: 560px !important; z-index: 99; }
  .stage .face canvas { visibility: visible !important; mask: none !important; }`

await main(async () => {
  const { launchBrowser, newPage } = await import('../packages/cli/dist/browser.js')
  const server = await serveSite()
  const browser = await launchBrowser()
  try {
    const page = await newPage(browser, { viewport: { width: 1280, height: 800 }, deviceScaleFactor: 2 })
    await page.goto(server.address)
    await page.addStyleTag({ content: FACE_ONLY })
    await page.keyboard.press('Shift')
    const canvas = await page.waitForSelector('canvas.drawn')
    // Waits until the expression and its wrinkles have faded in.
    await page.waitForTimeout(4000)
    const picture = await canvas.screenshot({ omitBackground: true })
    for (const [name, side] of POSTERS) {
      const file = join(ROOT, 'site/first-page', name)
      await sharp(picture).resize(side, side).webp({ quality: 82, effort: 6 }).toFile(file)
    }
  } finally {
    await browser.close()
    await server.close()
  }
})
