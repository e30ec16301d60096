import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Browser, Page } from 'playwright-core'
import sharp from 'sharp'
import { createServer, type ViteDevServer } from 'vite'
import { afterAll, afterEach, beforeAll, expect, test, vi } from 'vitest'
import { writeAvatars } from './avatars.ts'
import { openBrowser, openPage } from './browser.ts'
import { dropPaths, expectValue, shootStage, slider, waitUntilReady } from './studio-page.ts'

type Point = readonly [x: number, y: number]

const WAIT = { timeout: 60_000, interval: 200 }

const folder = mkdtempSync(join(tmpdir(), 'furrow-lines-'))
let server: ViteDevServer
let browser: Browser
let page: Page
let complaints: string[]
/** The face with automatic wrinkles and raised brows, and without lines over it. */
let raised: Buffer

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
    viewport: { width: 960, height: 640 },
    reducedMotion: 'reduce',
  }))
  await page.goto(`http://127.0.0.1:${(server.httpServer!.address() as { port: number }).port}/`)
  await waitUntilReady(page)
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await page.locator('#areas .row').first().waitFor()
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  await page.getByRole('button', { name: 'Surprised' }).click()
  await expectValue(slider(page, 'foreheadInnerLeft'), 1)
  raised = await shootStage(page)
}, 600_000)

afterAll(async () => {
  await browser?.close()
  await server?.close()
  rmSync(folder, { recursive: true, force: true })
})

afterEach(async () => {
  expect(complaints).toEqual([])
  expect(await page.textContent('#errors')).toBe('')
})

test('an automatic line of the forehead is bent by dragging its point, and undo restores the picture', async () => {
  await point('Edit')
  const line = await pixelOfLine()
  await page.mouse.click(...line)
  await slider(page, 'Width, mm').waitFor()
  const [x, y] = await pixelOfPoint()
  await drag([
    [x, y],
    [x, y + 8],
    [x, y + 16],
  ])
  await point('Off')
  await expectChange(y)
  await undo('Move a point')
  await expectRestored()
})

test('a line is drawn with one stroke, gets deeper by its slider, and undo takes both back', async () => {
  await point('Edit')
  const [x, y] = await pixelOfLine()
  await point('Draw')
  await drag(Array.from({ length: 9 }, (_, i) => [x + 2 * i, y - 30 + 8 * i] as const))
  await point('Off')
  const drawn = await expectChange(y)
  await point('Edit')
  await slider(page, 'Depth, mm').fill('1.5')
  await point('Off')
  await vi.waitFor(async () => expect((await shootStage(page)).equals(drawn)).toBe(false), WAIT)
  await undo('Change the depth of a line')
  await vi.waitFor(async () => expect((await shootStage(page)).equals(drawn)).toBe(true), WAIT)
  await undo('Draw a line')
  await expectRestored()
})

test('a line is removed by the Delete key', async () => {
  await point('Edit')
  const [x, y] = await pixelOfLine()
  await page.mouse.click(x, y)
  await slider(page, 'Width, mm').waitFor()
  await page.keyboard.press('Delete')
  await slider(page, 'Width, mm').waitFor({ state: 'detached' })
  await point('Off')
  await expectChange(y)
  await undo('Remove a line')
  await expectRestored()
})

/** Chooses what the pointer does. */
async function point(mode: 'Off' | 'Edit' | 'Draw'): Promise<void> {
  await page.getByRole('group', { name: 'Pointer' }).getByText(mode, { exact: true }).click()
  const hidden = mode === 'Off' ? '[hidden]' : ':not([hidden])'
  await page.locator(`.lines${hidden}`).waitFor({ state: 'attached' })
}

async function drag(way: readonly Point[]): Promise<void> {
  await page.mouse.move(...way[0])
  await page.mouse.down()
  for (const [x, y] of way) await page.mouse.move(x, y)
  await page.mouse.up()
}

async function undo(label: string): Promise<void> {
  await page.getByTitle(`Undo: ${label}`).click()
}

/** Waits until the face has changed near a height of the stage, and checks that its lower part has not. */
async function expectChange(y: number): Promise<Buffer> {
  let picture = raised
  await vi.waitFor(async () => {
    picture = await shootStage(page)
    expect(picture.equals(raised)).toBe(false)
  }, WAIT)
  const { data: before, info } = await sharp(raised).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  const after = await sharp(picture).removeAlpha().raw().toBuffer()
  const rows = [...after.keys()].filter((i) => Math.abs(after[i] - before[i]) > 4)
  expect(rows.length).toBeGreaterThan(20)
  for (const i of rows) {
    // Pictures begin 60 pixels below the stage's upper border.
    expect(Math.abs(60 + Math.floor(i / 3 / info.width) - y)).toBeLessThan(70)
  }
  return picture
}

async function expectRestored(): Promise<void> {
  await vi.waitFor(async () => expect((await shootStage(page)).equals(raised)).toBe(true), WAIT)
}

/** A pixel of the longest row of lines in the upper third of the face. */
function pixelOfLine(): Promise<[number, number]> {
  return pixelOf([255, 207, 155])
}

/** The white centre of a point of the chosen line. */
function pixelOfPoint(): Promise<[number, number]> {
  return pixelOf([255, 255, 255])
}

/** Of the pixels of a colour that are over the forehead, the one nearest to their mean; waits until there is one. */
async function pixelOf(colour: readonly [number, number, number]): Promise<[number, number]> {
  const find = async () => {
    const found = await page.evaluate(([r, g, b]) => {
      const canvas = document.querySelector<HTMLCanvasElement>('canvas.lines')!
      const { width, height } = canvas
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, width, height)
      const pixels: [number, number][] = []
      for (let i = 0; i < data.length; i += 4) {
        const isSame = data[i] === r && data[i + 1] === g && data[i + 2] === b && data[i + 3] === 255
        if (isSame) pixels.push([(i / 4) % width, Math.floor(i / 4 / width)])
      }
      // The highest lines are those of the forehead.
      const forehead = pixels.slice(0, Math.ceil(pixels.length / 8))
      const [x, y] = [0, 1].map((k) => forehead.reduce((sum, pixel) => sum + pixel[k], 0) / forehead.length)
      const away = ([px, py]: [number, number]) => Math.hypot(px - x, py - y)
      return forehead.sort((a, b) => away(a) - away(b))[0]
    }, colour)
    expect(found).toBeDefined()
    return found
  }
  return vi.waitFor(find, WAIT)
}
