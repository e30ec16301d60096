/** Maps in the studio: the texture's view, layers, area tools, views of the stage, and what performs under the pointer. */

import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Browser, Page } from 'playwright-core'
import { createServer, type ViteDevServer } from 'vite'
import { afterAll, afterEach, beforeAll, expect, test, vi } from 'vitest'
import { writeAvatars } from './avatars.ts'
import { openBrowser, openPage } from './browser.ts'
import { dropPaths, meanPngDifference, shootStage, waitUntilReady } from './studio-page.ts'

/** An automatic area of the forehead. */
const AREA = 'foreheadInnerLeft'

const folder = mkdtempSync(join(tmpdir(), 'furrow-maps-'))
let server: ViteDevServer
let browser: Browser
let page: Page
let complaints: string[]

beforeAll(async () => {
  await writeAvatars(folder)
  server = await createServer({
    configFile: fileURLToPath(new URL('../../studio/vite.config.ts', import.meta.url)),
    logLevel: 'error',
    server: { port: 0, host: '127.0.0.1', hmr: false, watch: null },
  })
  await server.listen()
  browser = await openBrowser()
  ;({ page, complaints } = await openPage(browser, {
    viewport: { width: 1100, height: 640 },
    reducedMotion: 'reduce',
  }))
  await page.goto(`http://127.0.0.1:${(server.httpServer!.address() as { port: number }).port}/`)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await choice(AREA).waitFor()
})

afterAll(async () => {
  await browser?.close()
  await server?.close()
  rmSync(folder, { recursive: true, force: true })
})

afterEach(async () => {
  expect(complaints).toEqual([])
  expect(await page.textContent('#errors')).toBe('')
})

const choice = (area: string) => page.getByRole('radio', { name: `Edit area ${area}`, exact: true })
const button = (name: string) => page.getByRole('button', { name, exact: true })
const texture = () => page.getByRole('application', { name: /^Texture/ })

test('the texture is shown beside the face, moved by keys and wheel, and shown whole again', async () => {
  const { width } = (await page.locator('#stage').boundingBox())!
  await button('Texture').click()
  await choice(AREA).check()
  const [stage, view] = await Promise.all([page.locator('#stage').boundingBox(), texture().boundingBox()])
  expect(stage!.width).toBeCloseTo(width / 2, 0)
  expect(view!.x).toBeCloseTo(stage!.x + stage!.width, 0)
  const whole = await shootTexture()
  const moved = async () => expect(await meanPngDifference(whole, await shootTexture())).toBeGreaterThan(3)
  for (const key of ['+', 'ArrowRight']) {
    await texture().press(key)
    await vi.waitFor(moved)
  }
  await texture().press('0')
  await vi.waitFor(async () => expect(await meanPngDifference(whole, await shootTexture())).toBe(0))
  await texture().hover({ position: { x: 60, y: 200 } })
  await page.mouse.wheel(0, -300)
  await vi.waitFor(moved)
  await texture().press('0')
})

test('a stroke on the texture paints the same place of the face, and its thumbnail', async () => {
  await button('Paint').click()
  const thumbnail = () =>
    choice(AREA).evaluate((radio) => (radio.nextElementSibling as HTMLCanvasElement).toDataURL())
  const [before, small] = [await shootAside(), await thumbnail()]
  const { x, y, width, height } = (await texture().boundingBox())!
  await page.mouse.move(x + 0.46 * width, y + 0.55 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.54 * width, y + 0.55 * height, { steps: 5 })
  await page.mouse.up()
  await vi.waitFor(async () => expect(await button('Undo').getAttribute('title')).toBe(`Undo: Paint ${AREA}`))
  const painted = await shootAside()
  expect(await meanPngDifference(before, painted)).toBeGreaterThan(0.2)
  await vi.waitFor(async () => expect(await thumbnail()).not.toBe(small))
  await button('Undo').click()
  await expectPicture(before)
  expect(await thumbnail()).toBe(small)
  await button('Paint').click()
})

test('a drag beside the skin moves the texture and paints nothing', async () => {
  await button('Paint').click()
  const before = await shootTexture()
  const { x, y, width, height } = (await texture().boundingBox())!
  await page.mouse.move(x + 0.5 * width, y + 0.03 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.3 * width, y + 0.2 * height, { steps: 3 })
  await page.mouse.up()
  await vi.waitFor(async () =>
    expect(await meanPngDifference(before, await shootTexture())).toBeGreaterThan(3),
  )
  expect(await button('Undo').isDisabled()).toBe(true)
  await button('Paint').click()
  await button('Texture').click()
  expect(await texture().isVisible()).toBe(false)
})

async function shootTexture(): Promise<Buffer> {
  await page.mouse.move(10, 600)
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  )
  return page.screenshot({ clip: (await texture().boundingBox())! })
}

/** The stage without the outlines of the brush and of the focus, nor what is hovered. */
async function shootAside(): Promise<Buffer> {
  await page.mouse.move(1090, 10)
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  return shootStage(page)
}

/** Waits until the stage is as a picture shows it, to the last bit. */
async function expectPicture(picture: Buffer): Promise<void> {
  const check = async () => expect(await meanPngDifference(picture, await shootAside())).toBe(0)
  await vi.waitFor(check, { timeout: 60_000, interval: 200 })
}
