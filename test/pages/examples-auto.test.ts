// Tests the example auto.html, which makes automatic wrinkles for a complete face.

import { afterAll, beforeAll, expect, test } from 'vitest'
import { openPage, useBrowser } from './browser.ts'
import { BROWS } from './examples.ts'
import { firstPicture, openPaused, readNextFrame, SECOND, switchWrinkles } from './paused-page.ts'
import { largestDifference } from './pixels.ts'
import { startStaticServer } from './static-server.ts'

const PHONE = { width: 390, height: 844 }

const browser = useBrowser()
let server: Awaited<ReturnType<typeof startStaticServer>>

beforeAll(async () => {
  server = await startStaticServer()
})

afterAll(async () => {
  server?.close()
})

test('auto.html makes wrinkles while the face is shown, and then removes its progress bar', async () => {
  const { page, complaints } = await openPage(browser(), { viewport: { width: 400, height: 300 } })
  await openPaused(page, `${server.origin}/examples/auto.html`)
  await firstPicture(page)
  await page.locator('progress').waitFor({ state: 'detached', timeout: 0 })
  // Lets the wrinkles fade in.
  await page.clock.runFor(2 * SECOND)
  const wrinkled = await readNextFrame(page)
  await switchWrinkles(page, 'off')
  expect(largestDifference(wrinkled, await readNextFrame(page), BROWS)).toBeGreaterThan(20)
  expect(complaints).toEqual([])
  await page.close()
})

test('auto.html shows the face and its progress bar while it makes wrinkles', async () => {
  const { page, complaints } = await openPage(browser(), { viewport: PHONE })
  // Delays the wrinkles until the test has seen the progress bar.
  let mayWork = () => {}
  const seen = new Promise<void>((resolve) => {
    mayWork = resolve
  })
  await page.route('**/auto-worker.js', (route) => seen.then(() => route.continue()))
  await openPaused(page, `${server.origin}/examples/auto.html`)
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(PHONE.width)
  await firstPicture(page)
  expect(await page.locator('progress').count()).toBe(1)
  const working = page.waitForResponse('**/auto-worker.js')
  mayWork()
  await working
  expect(complaints).toEqual([])
  await page.close()
})
