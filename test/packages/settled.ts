import type { Page } from 'playwright-core'
import { expect } from 'vitest'
import { meanPngDifference } from '../pages/studio-page.ts'

const DRAWING = { timeout: 120_000, interval: 500 }

/** Waits until two consecutive screenshots are equal and differ from `before`. Returns the last. */
export async function settled(page: Page, before: Buffer): Promise<Buffer> {
  let last = before
  const isSettled = async () => {
    const now = await page.screenshot()
    const [moved, changed] = await Promise.all([meanPngDifference(last, now), meanPngDifference(before, now)])
    last = now
    return moved === 0 && changed > 0.1
  }
  await expect.poll(isSettled, DRAWING).toBe(true)
  return last
}
