import { mkdir } from 'node:fs/promises'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { openPage, useBrowser } from './browser.ts'
import { answerCdn } from './cdn.ts'
import { addressOf, type Controls, EXAMPLES, type Example } from './examples.ts'
import {
  drawSettled,
  openPaused,
  playSurprise,
  readNextFrame,
  resize,
  SECOND,
  switchWrinkles,
} from './paused-page.ts'
import { contrast, largestDifference, WHOLE } from './pixels.ts'
import { type CanvasPixels, readCanvas } from './read-canvas.ts'
import { startStaticServer } from './static-server.ts'

/** Folder in which developers find pictures of the examples. */
const OUTPUT = new URL('../output/examples/', import.meta.url)

const PHONE = { width: 390, height: 844 }
const SIZE = { width: 400, height: 300 }

/** Functions that open examples. */
export interface ExampleOpener {
  /**
   * Opens an example and advances its time until the face looks surprised. Fails if the page reports an error or warning. Also fails if a
   * page with controls is wider than a phone.
   */
  open<T>(address: string, inspect: (page: Page) => Promise<T>): Promise<T>
  /** Adds a test that the example's region changes when wrinkles are switched off, and when the controls have the values `atRest`. */
  testWrinkles(example: Example): void
}

/** Starts a browser and a server for all tests of a file. */
export function useExamples(): ExampleOpener {
  const browser = useBrowser()
  let server: Awaited<ReturnType<typeof startStaticServer>>

  beforeAll(async () => {
    server = await startStaticServer()
    await mkdir(OUTPUT, { recursive: true })
  })

  afterAll(() => server?.close())

  const open: ExampleOpener['open'] = async (address, inspect) => {
    const hasControls = EXAMPLES.some(({ page, atRest }) => atRest && address.startsWith(`${page}.html`))
    const { page, complaints } = await openPage(browser(), {
      viewport: hasControls ? PHONE : SIZE,
    })
    page.on('console', (message) => {
      const text = message.text()
      // Ignores performance messages of the graphics driver, and the warning of React Three Fiber 9 about a deprecated clock.
      if (message.type() === 'warning' && !/GL Driver Message|THREE\.Clock/.test(text)) complaints.push(text)
    })
    await answerCdn(page)
    try {
      await openPaused(page, `${server.origin}/examples/${address}`)
      if (hasControls) {
        const width = await page.evaluate(() => document.documentElement.scrollWidth)
        expect(width).toBeLessThanOrEqual(PHONE.width)
        await resize(page, SIZE)
      }
      await playSurprise(page)
      if (hasControls) await drawSettled(page)
      const result = await inspect(page)
      expect(complaints).toEqual([])
      return result
    } finally {
      await page.close()
    }
  }

  return { open, testWrinkles: (example) => testWrinkles(open, example) }
}

function testWrinkles(open: ExampleOpener['open'], example: Example): void {
  const { atRest, region, moves } = example
  const address = addressOf(example)
  test(`${address} shows wrinkles${atRest ? ', and its controls remove them' : ''}`, () =>
    open(address, async (page) => {
      const wrinkled = await readCanvas(page)
      await savePicture(wrinkled, address)
      expect(contrast(wrinkled)).toBeGreaterThan(100)
      // While nothing moves, the next frame is equal.
      if (atRest && !moves) expect(largestDifference(wrinkled, await readNextFrame(page), WHOLE)).toBe(0)
      await switchWrinkles(page, 'off')
      expect(largestDifference(wrinkled, await readNextFrame(page), region)).toBeGreaterThan(20)
      if (!atRest) return
      await switchWrinkles(page, 'default')
      expect(largestDifference(wrinkled, await setControls(page, atRest), region)).toBeGreaterThan(20)
    }))
}

/** Sets controls of an example. Returns the picture a minute later, when transitions and delays have ended. */
export async function setControls(page: Page, controls: Controls): Promise<CanvasPixels> {
  for (const [name, value] of Object.entries(controls)) {
    if (value === true) await page.locator('form').getByText(name, { exact: true }).dispatchEvent('click')
    else await page.locator('form').getByLabel(name).fill(String(value))
  }
  await page.clock.runFor(SECOND / 60)
  await page.clock.fastForward(60 * SECOND)
  return readNextFrame(page)
}

export async function savePicture({ width, height, data }: CanvasPixels, address: string): Promise<void> {
  const file = new URL(`${address.replace('.html', '').replace(/[?&]/g, '-')}.png`, OUTPUT).pathname
  await sharp(data, { raw: { width, height, channels: 3 } }).toFile(file)
}
