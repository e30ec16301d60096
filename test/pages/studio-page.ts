/** What the studio's tests do on its page, and how they look at it. */

import type { Locator, Page } from 'playwright-core'
import sharp from 'sharp'
import { expect, vi } from 'vitest'

export async function ready(page: Page, backend = ''): Promise<void> {
  await page.locator('#backend', { hasText: new RegExp(`^${backend}`) }).waitFor({ state: 'attached' })
  await page.locator('#stage[aria-busy=false]').waitFor()
}

export function slider(page: Page, name: string): Locator {
  return page.getByLabel(name, { exact: true })
}

export function expectValue(input: Locator, value: number): Promise<void> {
  const check = async () => expect(Number(await input.inputValue())).toBeCloseTo(value, 2)
  return vi.waitFor(check, { timeout: 300_000, interval: 100 })
}

/** The stage as the browser shows it, once two pictures in a row are the same. */
export async function face(page: Page): Promise<Buffer> {
  const { width, height } = (await page.locator('#viewport').boundingBox())!
  // Between toolbar and read-out, whose numbers change by themselves, and without what lies over the face.
  const clip = { x: 0, y: 60, width, height: height - 180 }
  const shoot = () => page.screenshot({ clip, style: '.messages, .divider, .sides { opacity: 0 }' })
  for (let before = await shoot(); ; ) {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))))
    const after = await shoot()
    if (before.equals(after)) return after
    before = after
  }
}

/** Mean difference of two pictures, 0..255. */
export async function difference(a: Buffer, b: Buffer): Promise<number> {
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).removeAlpha().raw().toBuffer()))
  expect(other.length).toBe(one.length)
  return one.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / one.length
}

/** Standard deviation of a picture's brightness: 0 where it is blank. */
export async function spread(png: Buffer): Promise<number> {
  const { channels } = await sharp(png).grayscale().stats()
  return channels[0].stdev
}

/** Waits for an error that says so, and dismisses it. */
export async function dismiss(page: Page, text: string): Promise<void> {
  await page.getByRole('alert').getByText(text).waitFor()
  await page.getByRole('button', { name: 'Dismiss' }).click()
}

/** An area that is everywhere, as the paper paints them. */
export function black(): Promise<Buffer> {
  return sharp({ create: { width: 32, height: 32, channels: 3, background: '#000' } })
    .png()
    .toBuffer()
}

export async function drop(page: Page, name: string, content: Buffer): Promise<void> {
  const files = await page.evaluateHandle(
    ([fileName, base64]) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))
      const transfer = new DataTransfer()
      transfer.items.add(new File([bytes], fileName, { type: 'image/png' }))
      return transfer
    },
    [name, content.toString('base64')],
  )
  await page.dispatchEvent('#stage', 'dragover', { dataTransfer: files })
  expect(await page.locator('#dropping').isVisible()).toBe(true)
  await page.dispatchEvent('#stage', 'drop', { dataTransfer: files })
}

/** The different values that a slider takes after an expression's button is pressed, until nothing moves. */
export async function valuesOnTheWay(page: Page, expression: string, name: string): Promise<number[]> {
  const input = await slider(page, name).elementHandle()
  return page.getByRole('button', { name: expression }).evaluate(async (button, shown) => {
    ;(button as HTMLElement).click()
    const values = new Set<number>()
    // Frames are counted too: a slow machine draws few of them in a second, and moves on by steps of 0.1 s.
    for (let frame = 0, start = performance.now(); frame < 12 || performance.now() - start < 1000; frame++) {
      values.add((shown as HTMLInputElement).valueAsNumber)
      await new Promise(requestAnimationFrame)
    }
    return [...values]
  }, input)
}
