// Tests the example that makes automatic wrinkles, which takes the time of a complete face.

import { afterAll, beforeAll, expect, test } from 'vitest'
import { openPage, useBrowser } from './browser.ts'
import { firstPicture, openPaused, readNextFrame, SECOND, switchWrinkles } from './paused-page.ts'
import { largestDifference } from './pixels.ts'
import { startStaticServer } from './static-server.ts'

const BROWS = { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }

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
  // The wrinkles have faded in.
  await page.clock.runFor(2 * SECOND)
  const wrinkled = await readNextFrame(page)
  await switchWrinkles(page, 'off')
  expect(largestDifference(wrinkled, await readNextFrame(page), BROWS)).toBeGreaterThan(20)
  expect(complaints).toEqual([])
  await page.close()
})
