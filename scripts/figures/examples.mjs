// Takes the pictures of the examples, examples/pictures/NAME.jpg, and draws all of them on one sheet.

import { mkdir } from 'node:fs/promises'
import { join } from 'node:path'
import { exampleNames, readExamples } from '../lib/examples.mjs'
import { importSource } from '../lib/import-source.mjs'
import { ROOT, say } from '../lib/run.mjs'

const FOLDER = 'examples/pictures'
const SHEET = 'docs/figures/examples.jpg'
const SIZE = { width: 480, height: 360 }
/** Window size, pixels. A picture shows a part of the window, scaled down. */
const VIEWPORT = { width: 1280, height: 960 }
/** Number of columns on the sheet, and width of a column in pixels. */
const COLUMNS = 6
const COLUMN_WIDTH = 240
const GAP = 6

const names = new Set(exampleNames().map((name) => `examples/${name}`))

/** Returns whether a figure name is `examples` (the pictures of all examples), or `examples/NAME` of an example. */
export const isExamplePicture = (name) => name === 'examples' || names.has(name)

/** Takes the pictures of the selected examples, or of all examples if none is selected. Then draws the sheet again. */
export async function writeExamplePictures(selected) {
  const all = selected.length === 0 || selected.includes('examples')
  const { EXAMPLES, FACE } = await importSource('test/pages/examples.ts')
  const shown = new Map(EXAMPLES.toReversed().map((example) => [example.page, { frame: FACE, ...example }]))
  const chosen = exampleNames().filter((name) => all || selected.includes(`examples/${name}`))
  await mkdir(join(ROOT, FOLDER), { recursive: true })
  await takePictures(chosen.map((name) => shown.get(name)))
  await writeSheet(readExamples().map(({ name }) => name))
}

async function takePictures(examples) {
  const { default: sharp } = await import('sharp')
  const { startStaticServer } = await importSource('test/pages/static-server.ts')
  const pages = await importSource('test/pages/paused-page.ts')
  const { answerCdn } = await importSource('test/pages/cdn.ts')
  const { launchBrowser } = await import('../../packages/cli/dist/browser.js')
  const server = await startStaticServer()
  const browser = await launchBrowser()
  try {
    for (const { page: name, query = '', picture = query, frame } of examples) {
      const page = await browser.newPage({ viewport: VIEWPORT })
      await answerCdn(page)
      await openSettled(page, pages, `${server.origin}/examples/${name}.html${picture}`)
      const file = `${FOLDER}/${name}.jpg`
      const small = sharp(await page.screenshot())
        .extract(pixelsOf(frame))
        .resize(SIZE.width, SIZE.height)
      await small.jpeg({ quality: 82, mozjpeg: true }).toFile(join(ROOT, file))
      await page.close()
      say(file)
    }
  } finally {
    await browser.close()
    server.close()
  }
}

/** Converts a rectangle from fractions of the window to pixels. */
function pixelsOf({ left, top, right, bottom }) {
  const { width, height } = VIEWPORT
  const [x, y] = [Math.round(left * width), Math.round(top * height)]
  return { left: x, top: y, width: Math.round(right * width) - x, height: Math.round(bottom * height) - y }
}

/** Opens an example and waits until its face looks surprised. Hides the controls below the canvas. */
async function openSettled(page, { drawSettled, openPaused, playSurprise, SECOND }, url) {
  // Hides WebGPU from the page. Without a GPU, the browser cannot capture a WebGPU canvas.
  await page.addInitScript('Object.defineProperty(Navigator.prototype, "gpu", { value: undefined })')
  await openPaused(page, url)
  await page.addStyleTag({ content: 'form { display: none !important }' })
  await page.evaluate('dispatchEvent(new Event("resize"))')
  // Waits until no progress bar is left, i.e. until files are loaded and automatic wrinkles are generated. Both take real
  // time, although the clock of the page is paused.
  while ((await page.locator('progress').count()) > 0) {
    await page.clock.runFor(SECOND / 60)
    await page.waitForTimeout(SECOND / 10)
  }
  await playSurprise(page)
  await drawSettled(page)
}

async function writeSheet(names) {
  const { default: sharp } = await import('sharp')
  const height = (COLUMN_WIDTH * SIZE.height) / SIZE.width
  const layers = await Promise.all(
    names.map(async (name, i) => ({
      input: await sharp(join(ROOT, FOLDER, `${name}.jpg`))
        .resize(COLUMN_WIDTH, height)
        .toBuffer(),
      left: (i % COLUMNS) * (COLUMN_WIDTH + GAP),
      top: Math.floor(i / COLUMNS) * (height + GAP),
    })),
  )
  const rows = Math.ceil(names.length / COLUMNS)
  const create = {
    width: COLUMNS * (COLUMN_WIDTH + GAP) - GAP,
    height: rows * (height + GAP) - GAP,
    channels: 3,
    background: '#fff',
  }
  await sharp({ create }).composite(layers).jpeg({ quality: 80, mozjpeg: true }).toFile(join(ROOT, SHEET))
  say(SHEET)
}
